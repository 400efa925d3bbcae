/** The commands that change the drawing: modes, history, selection, snapping, wishes, crossings. */
package dct.ui.edit;
