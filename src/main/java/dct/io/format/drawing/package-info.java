/** Reads drawings that are XML: SVG and the files and selections of Ipe. */
package dct.io.format.drawing;
