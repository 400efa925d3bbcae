/** Random sites and polygons: the form, the plan that it makes, and the work. */
package dct.ui.random;
