/** Charts of numbers, on the screen and in files. */
package dct.render.chart;
