/**
 * Degrees and their parity: Scan-Flip, the triangulations of convex pieces, what is wished of each
 * vertex, and how near a result comes. The packages below search for the best triangulation: {@code
 * best} is what other packages call; {@code exact}, {@code region} and {@code strip} compute;
 * {@code bound} proves what cannot be bettered.
 */
package dct.core.degree;
