package dct.core.degree.region;

/**
 * The {@link ChordTable} of a small polygon, used for one after the other.
 *
 * <p>A triangle is allowed if it is strictly counter-clockwise: triangles that fit together along
 * the whole boundary and are all counter-clockwise tile the polygon, so that no test of visibility
 * is needed. Each chord has a random cost of its own, which breaks ties. O(m³) time for m vertices;
 * the memory is allocated once.
 */
final class RegionTable extends UnmetTable {
  /** The largest number of vertices: the bits of a long. */
  static final int MOST = Long.SIZE;

  private final RegionChords chords;
  private final int[] own; // by chord

  /**
   * A table for polygons of at most so many vertices.
   *
   * @param x where {@link #solve} finds their coordinates, counter-clockwise
   * @param costs where it finds their costs
   */
  RegionTable(SearchMesh mesh, double[] x, double[] y, int[] costs, int most) {
    super(costs, RegionChords.count(most));
    chords = new RegionChords(mesh, x, y, most);
    own = new int[RegionChords.count(most)];
  }

  /**
   * Fills the table for the first so many vertices.
   *
   * @param noiseBits chords cost a random amount below 2 to this power, which is at least 1
   */
  void solve(int vertices, int noiseBits, int noiseSeed) {
    int drop = Integer.SIZE - noiseBits;
    int noise = noiseSeed;
    chords.clear(vertices);
    for (int j = 1; j < vertices; j++) {
      int side = at(j - 1, j);
      store(j, side, side, 0, INFINITE, INFINITE, INFINITE);
      chords.mark(j - 1, j);
      for (int i = j - 2; i >= 0; i--) {
        noise = noise * 1664525 + 1013904223;
        own[at(i, j) >> 2] = noise >>> drop;
        combine(i, j);
      }
    }
  }

  /** Long because it is the kernel: its loop runs once for each triangle. */
  private void combine(int i, int j) {
    int m00 = INFINITE;
    int m01 = INFINITE;
    int m10 = INFINITE;
    int m11 = INFINITE;
    long apexes = chords.apexes(i, j);
    while (apexes != 0) {
      int k = Long.numberOfTrailingZeros(apexes);
      apexes &= apexes - 1;
      if (chords.isTriangle(i, k, j)) {
        int g = at(i, k);
        int f = at(k, j);
        int g00 = closed[g];
        int g01 = closed[g + 1];
        int g10 = closed[g + 2];
        int g11 = closed[g + 3];
        int f00 = best[f];
        int f01 = best[f + 1];
        int f10 = best[f + 2];
        int f11 = best[f + 3];
        m00 = Math.min(m00, Math.min(g00 + f00, g01 + f10));
        m01 = Math.min(m01, Math.min(g00 + f01, g01 + f11));
        m10 = Math.min(m10, Math.min(g10 + f00, g11 + f10));
        m11 = Math.min(m11, Math.min(g10 + f01, g11 + f11));
      }
    }
    if (Math.min(Math.min(m00, m01), Math.min(m10, m11)) < INFINITE) {
      int chord = own(i, j);
      store(j, at(i, j), at(i, j), m11 + chord, m10 + chord, m01 + chord, m00 + chord);
      chords.mark(i, j);
    }
  }

  @Override
  int apexAfter(int k, int i, int j) {
    return chords.apexAfter(k, i, j);
  }

  @Override
  int size() {
    return chords.size();
  }

  @Override
  int at(int i, int j) {
    return chords.at(i, j);
  }

  @Override
  int own(int i, int j) {
    return own[at(i, j) >> 2];
  }
}
