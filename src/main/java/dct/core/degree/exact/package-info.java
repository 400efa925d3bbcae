/** Exact optima: the table over the chords of a polygon, and the sweep over a few sites. */
package dct.core.degree.exact;
