/**
 * Degrees and their parity: Scan-Flip, the triangulations of convex pieces, and the words for what
 * is wished of each vertex and how near a result comes. The searches for the best triangulation
 * stand in rooms of their own: {@code best} is the door, {@code exact} and {@code search} do the
 * work, {@code bound} proves what cannot be bettered.
 */
package dct.core.degree;
