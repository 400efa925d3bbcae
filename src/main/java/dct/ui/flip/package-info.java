/** Flips by hand, and the lists of flips: played, saved, loaded and applied. */
package dct.ui.flip;
