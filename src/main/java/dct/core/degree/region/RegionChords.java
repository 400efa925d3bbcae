package dct.core.degree.region;

import java.util.Arrays;

/**
 * The chords of a small polygon for a table: those whose part can be triangulated are marked as the
 * table is filled, a bit for each.
 *
 * <p>A triangle is allowed if it is strictly counter-clockwise: triangles that fit together along
 * the whole boundary and are all counter-clockwise tile the polygon, so that no test of visibility
 * is needed.
 */
final class RegionChords {
  private final SearchMesh mesh;
  private final double[] x;
  private final double[] y;
  private final int shift; // a row has 1 << shift chords
  private final long[] from; // by i: the chords (i, j) that can be filled, a bit for each j
  private final long[] into; // by j: the chords (i, j) that can be filled, a bit for each i
  private int size;

  /**
   * The chords of polygons of at most so many vertices, whose coordinates then stand in x and y.
   */
  RegionChords(SearchMesh mesh, double[] x, double[] y, int most) {
    this.mesh = mesh;
    this.x = x;
    this.y = y;
    shift = shift(most);
    from = new long[most];
    into = new long[most];
  }

  private static int shift(int most) {
    return Integer.SIZE - Integer.numberOfLeadingZeros(most - 1);
  }

  /** How many chords a table for so many vertices has room for. */
  static int count(int most) {
    return 1 << (2 * shift(most));
  }

  /** Begins with a polygon of so many vertices. */
  void clear(int vertices) {
    size = vertices;
    Arrays.fill(from, 0, vertices, 0);
    Arrays.fill(into, 0, vertices, 0);
  }

  /** The number of vertices. */
  int size() {
    return size;
  }

  /** The part of the chord (i, j) can be triangulated. */
  void mark(int i, int j) {
    from[i] |= 1L << j;
    into[j] |= 1L << i;
  }

  /** The vertices to which both ends of a chord have marked chords, a bit for each. */
  long apexes(int i, int j) {
    return from[i] & into[j];
  }

  /** Whether three vertices are strictly counter-clockwise. */
  boolean isTriangle(int i, int k, int j) {
    return mesh.isLeftTurn(x[i], y[i], x[k], y[k], x[j], y[j]);
  }

  /** The lowest apex above k of a triangle on the chord (i, j), or j if there is none. */
  int apexAfter(int k, int i, int j) {
    long apexes = apexes(i, j) & (-2L << k);
    while (apexes != 0) {
      int apex = Long.numberOfTrailingZeros(apexes);
      apexes &= apexes - 1;
      if (isTriangle(i, apex, j)) {
        return apex;
      }
    }
    return j;
  }

  /** Where the four entries of the chord (i, j) are. */
  int at(int i, int j) {
    return ((i << shift) + j) << 2;
  }
}
