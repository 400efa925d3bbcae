/**
 * Documents and pictures on disk, from the window: opening, saving, exporting, dropping, closing.
 */
package dct.ui.file;
