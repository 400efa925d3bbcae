/**
 * The window of the thesis: a canvas, an east panel, and frames for results. {@link
 * dct.ui.MainWindow} puts together what the packages below hold; none of them knows it.
 */
package dct.ui;
