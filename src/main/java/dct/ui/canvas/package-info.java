/** The panel that shows a scene, and the mouse on it. */
package dct.ui.canvas;
