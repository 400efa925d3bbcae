/**
 * Questions, forms, file choosers and failures, each over the window that it belongs to; where
 * windows are put.
 */
package dct.ui.dialog;
