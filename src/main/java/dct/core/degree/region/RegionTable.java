package dct.core.degree.region;

/**
 * The best triangulation of a small polygon, given the parities outside it: exact.
 *
 * <p>For each chord (i, j), i &lt; j, and each pair of parities (a, b) the table holds the least
 * cost of the vertices strictly between i and j over all triangulations of the sub-polygon i … j
 * with a triangles at i and b at j, mod 2. It is combined over the apex k of the triangle on the
 * chord. A triangle is allowed if it is strictly counter-clockwise: triangles that fit together
 * along the whole boundary and are all counter-clockwise tile the polygon, so that no test of
 * visibility is needed.
 *
 * <p>Each vertex has a cost for an even and one for an odd number of triangles, each chord a cost
 * of its own. O(m³) time for m vertices, at most 64; the memory is allocated once.
 */
final class RegionTable {
  private static final int INFINITE = 1 << 28;

  private final SearchMesh mesh;
  private final int shift; // a row has 1 << shift chords
  private final int[] best; // by chord and a, b: the least cost between its ends
  private final int[] closed; // by chord (i, k) and a, y: with k closed, y triangles beyond it at k
  private final int[] chordCost; // by chord / 4: its own cost
  private final long[] from; // by i: the chords (i, j) that can be filled, a bit for each j
  private final long[] into; // by j: the chords (i, j) that can be filled, a bit for each i
  final int[] even; // by vertex: its cost if an even number of triangles meet there
  final int[] odd; // by vertex: its cost if an odd number of triangles meet there
  private int m;
  private int a; // parities at the ends of the last chord, as the best solution has them
  private int b;

  RegionTable(SearchMesh mesh, int most) {
    this.mesh = mesh;
    shift = 32 - Integer.numberOfLeadingZeros(most - 1);
    best = new int[4 << (2 * shift)];
    closed = new int[best.length];
    chordCost = new int[1 << (2 * shift)];
    from = new long[1 << shift];
    into = new long[1 << shift];
    even = new int[1 << shift];
    odd = new int[1 << shift];
  }

  /**
   * Fills the table.
   *
   * @param px the x-coordinates of the polygon, counter-clockwise
   * @param size the number of its vertices
   * @param noiseBits chords cost a random amount below 2 to this power, which is at least 1
   * @return the least cost of all vertices
   */
  int solve(double[] px, double[] py, int size, int noiseBits, int noiseSeed) {
    m = size;
    int drop = 32 - noiseBits;
    int noise = noiseSeed;
    for (int j = 0; j < size; j++) {
      from[j] = 0;
      into[j] = 0;
    }
    for (int j = 1; j < size; j++) {
      addSide(j - 1, j);
      for (int i = j - 2; i >= 0; i--) {
        noise = noise * 1664525 + 1013904223;
        chordCost[(i << shift) + j] = noise >>> drop;
        combine(px, py, i, j);
      }
    }
    return close();
  }

  private int chord(int i, int j) {
    return ((i << shift) + j) << 2;
  }

  private void addSide(int i, int j) {
    int c = chord(i, j);
    best[c] = 0;
    best[c + 1] = INFINITE;
    best[c + 2] = INFINITE;
    best[c + 3] = INFINITE;
    closed[c] = INFINITE;
    closed[c + 1] = INFINITE;
    closed[c + 2] = odd[j];
    closed[c + 3] = even[j];
    mark(i, j);
  }

  private void mark(int i, int j) {
    from[i] |= 1L << j;
    into[j] |= 1L << i;
  }

  /** The hot loop; a parity pair (a, b) is the number 2a + b. */
  private void combine(double[] px, double[] py, int i, int j) {
    int m0 = INFINITE;
    int m1 = INFINITE;
    int m2 = INFINITE;
    int m3 = INFINITE;
    long apexes = from[i] & into[j];
    while (apexes != 0) {
      int k = Long.numberOfTrailingZeros(apexes);
      apexes &= apexes - 1;
      if (mesh.isLeftTurn(px[i], py[i], px[k], py[k], px[j], py[j])) {
        int l = chord(i, k);
        int r = chord(k, j);
        int r0 = best[r];
        int r1 = best[r + 1];
        int r2 = best[r + 2];
        int r3 = best[r + 3];
        int l0 = closed[l];
        int l1 = closed[l + 1];
        int l2 = closed[l + 2];
        int l3 = closed[l + 3];
        m0 = Math.min(m0, Math.min(l0 + r1, l1 + r3));
        m1 = Math.min(m1, Math.min(l0 + r0, l1 + r2));
        m2 = Math.min(m2, Math.min(l2 + r1, l3 + r3));
        m3 = Math.min(m3, Math.min(l2 + r0, l3 + r2));
      }
    }
    if (Math.min(Math.min(m0, m1), Math.min(m2, m3)) < INFINITE) {
      int own = chordCost[(i << shift) + j];
      store(i, j, m0 + own, m1 + own, m2 + own, m3 + own);
    }
  }

  private void store(int i, int j, int m0, int m1, int m2, int m3) {
    int c = chord(i, j);
    int b0 = Math.min(m0, INFINITE);
    int b1 = Math.min(m1, INFINITE);
    int b2 = Math.min(m2, INFINITE);
    int b3 = Math.min(m3, INFINITE);
    best[c] = b0;
    best[c + 1] = b1;
    best[c + 2] = b2;
    best[c + 3] = b3;
    int e = even[j];
    int o = odd[j];
    // Closed under a further triangle at i and at j: x triangles at j so far make x + 1 + y.
    closed[c] = Math.min(INFINITE, Math.min(b2 + o, b3 + e));
    closed[c + 1] = Math.min(INFINITE, Math.min(b2 + e, b3 + o));
    closed[c + 2] = Math.min(INFINITE, Math.min(b0 + o, b1 + e));
    closed[c + 3] = Math.min(INFINITE, Math.min(b0 + e, b1 + o));
    mark(i, j);
  }

  private int close() {
    int c = chord(0, m - 1);
    int least = Integer.MAX_VALUE;
    for (int ab = 0; ab < 4; ab++) {
      int cost = best[c + ab];
      cost += ab < 2 ? even[0] : odd[0];
      cost += (ab & 1) == 0 ? even[m - 1] : odd[m - 1];
      if (cost < least) {
        least = cost;
        a = ab >> 1;
        b = ab & 1;
      }
    }
    return least;
  }

  /** The parities, 2a + b, that the best solution has at the ends of the chord (0, m − 1). */
  int ends() {
    return 2 * a + b;
  }

  /**
   * The apex on chord (i, j) in the best solution with these parities at its ends.
   *
   * @return the apex k, and the parities on the chords (i, k) and (k, j), as 16k + 4(2a + x) + 2y +
   *     b
   */
  int apex(double[] px, double[] py, int i, int j, int ends) {
    int wanted = best[chord(i, j) + ends] - chordCost[(i << shift) + j];
    int endA = ends >> 1;
    int endB = ends & 1;
    long apexes = from[i] & into[j];
    while (apexes != 0) {
      int k = Long.numberOfTrailingZeros(apexes);
      apexes &= apexes - 1;
      if (mesh.isLeftTurn(px[i], py[i], px[k], py[k], px[j], py[j])) {
        for (int xy = 0; xy < 4; xy++) {
          int left = 2 * (endA ^ 1) + (xy >> 1);
          int right = 2 * (xy & 1) + (endB ^ 1);
          int atApex = ((xy >> 1) ^ xy ^ 1) & 1;
          int cost = best[chord(i, k) + left] + best[chord(k, j) + right];
          cost += atApex == 0 ? even[k] : odd[k];
          if (cost == wanted) {
            return 16 * k + 4 * left + right;
          }
        }
      }
    }
    throw new IllegalStateException("no triangle on chord " + i + ", " + j);
  }
}
