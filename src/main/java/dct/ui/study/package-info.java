/** The studies in the window: their dialog, which knows no other window. */
package dct.ui.study;
