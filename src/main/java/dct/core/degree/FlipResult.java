package dct.core.degree;

import dct.core.triangulate.Triangulation;

/**
 * A triangulation before and after flips.
 *
 * @param before the triangulation that was given
 * @param after the one that came out; the edges that flips made are of kind {@link
 *     dct.core.triangulate.EdgeKind#FLIPPED}
 * @param flips the number of flips
 */
public record FlipResult(Triangulation before, Triangulation after, int flips) {}
