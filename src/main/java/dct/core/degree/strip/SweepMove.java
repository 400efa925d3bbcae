package dct.core.degree.strip;

/**
 * The moves of a sweep over a {@link Strip}, from its lower path to its upper one. At the next edge
 * (a, b) of the path that is the upper side so far:
 *
 * <pre>
 *         c                z ───────── b
 *       ↗   ↘                ↘       ↗
 *     a ····· b                  a
 *    join: the number c       CUT: a is finished
 * </pre>
 *
 * WAIT: the triangle above (a, b) shall be cut off together with the edge after it; CLOSE: the edge
 * belongs to the upper path, and a is finished.
 *
 * <p>As each edge is decided before any to its right, every triangulation comes from one sequence
 * of moves only: that which always adds the leftmost triangle that can be added, as the marked
 * monotone paths of V. Alvarez and R. Seidel do (<i>A Simple Aggregative Algorithm for Counting
 * Triangulations of Planar Point Sets and Related Problems</i>, 2013). And all sequences have the
 * same length: the joins bring in the vertices above the lower path, the cuts take out those below
 * the upper path, each cut ends one wait, and each edge of the upper path is closed once.
 */
final class SweepMove {
  static final int CLOSE = -1;
  static final int WAIT = -2;
  static final int CUT = -3;

  private SweepMove() {}
}
