/**
 * The window of the thesis: a canvas, an east panel, and frames for results; over a {@link
 * dct.ui.Workbench} that knows no Swing component.
 */
package dct.ui;
