/** The table of the vertices beside the canvas: it shows a document and changes it by edits. */
package dct.ui.vertices;
