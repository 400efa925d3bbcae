package dct.core.degree.search;

/**
 * Draws a triangulation of a small polygon at random, given the parities outside it: each with a
 * probability in proportion to the product of the factors of its vertices. Exact, by the table of
 * {@link RegionTable} with sums of products in place of minima of sums.
 *
 * <p>Each vertex has a factor for an even and one for an odd number of triangles. With a small
 * factor for the parity that is not wished, triangulations with fewest unsatisfied vertices are all
 * about equally likely, and those with more of them rare. O(m³) time for m vertices, at most 64.
 */
final class RegionSampler {
  private final SearchMesh mesh;
  private final SearchRandom random;
  private final int shift; // a row has 1 << shift chords
  private final double[] sum; // by chord and a, b: over all triangulations between its ends
  private final double[] closed; // by chord (i, k) and a, y: with k closed, y triangles beyond it
  private final long[] from; // by i: the chords (i, j) that can be filled, a bit for each j
  private final long[] into; // by j: the chords (i, j) that can be filled, a bit for each i
  final double[] even; // by vertex: its factor if an even number of triangles meet there
  final double[] odd; // by vertex: its factor if an odd number of triangles meet there

  RegionSampler(SearchMesh mesh, SearchRandom random, int most) {
    this.mesh = mesh;
    this.random = random;
    shift = 32 - Integer.numberOfLeadingZeros(most - 1);
    sum = new double[4 << (2 * shift)];
    closed = new double[sum.length];
    from = new long[1 << shift];
    into = new long[1 << shift];
    even = new double[1 << shift];
    odd = new double[1 << shift];
  }

  /**
   * Fills the table for a polygon.
   *
   * @return the parities, 2a + b, drawn for the ends of the chord (0, m − 1)
   */
  int draw(double[] px, double[] py, int m) {
    for (int j = 0; j < m; j++) {
      from[j] = 0;
      into[j] = 0;
    }
    for (int j = 1; j < m; j++) {
      addSide(j - 1, j);
      for (int i = j - 2; i >= 0; i--) {
        combine(px, py, i, j);
      }
    }
    return drawEnds(m - 1);
  }

  private int chord(int i, int j) {
    return ((i << shift) + j) << 2;
  }

  private void addSide(int i, int j) {
    int c = chord(i, j);
    sum[c] = 1;
    sum[c + 1] = 0;
    sum[c + 2] = 0;
    sum[c + 3] = 0;
    closed[c] = 0;
    closed[c + 1] = 0;
    closed[c + 2] = odd[j];
    closed[c + 3] = even[j];
    from[i] |= 1L << j;
    into[j] |= 1L << i;
  }

  /** The hot loop; a parity pair (a, b) is the number 2a + b. */
  private void combine(double[] px, double[] py, int i, int j) {
    double s0 = 0;
    double s1 = 0;
    double s2 = 0;
    double s3 = 0;
    long apexes = from[i] & into[j];
    while (apexes != 0) {
      int k = Long.numberOfTrailingZeros(apexes);
      apexes &= apexes - 1;
      if (mesh.isLeftTurn(px[i], py[i], px[k], py[k], px[j], py[j])) {
        int l = chord(i, k);
        int r = chord(k, j);
        s0 += closed[l] * sum[r + 1] + closed[l + 1] * sum[r + 3];
        s1 += closed[l] * sum[r] + closed[l + 1] * sum[r + 2];
        s2 += closed[l + 2] * sum[r + 1] + closed[l + 3] * sum[r + 3];
        s3 += closed[l + 2] * sum[r] + closed[l + 3] * sum[r + 2];
      }
    }
    if (s0 + s1 + s2 + s3 > 0) {
      int c = chord(i, j);
      sum[c] = s0;
      sum[c + 1] = s1;
      sum[c + 2] = s2;
      sum[c + 3] = s3;
      closed[c] = s2 * odd[j] + s3 * even[j];
      closed[c + 1] = s2 * even[j] + s3 * odd[j];
      closed[c + 2] = s0 * odd[j] + s1 * even[j];
      closed[c + 3] = s0 * even[j] + s1 * odd[j];
      from[i] |= 1L << j;
      into[j] |= 1L << i;
    }
  }

  private int drawEnds(int last) {
    int c = chord(0, last);
    double p0 = sum[c] * even[0] * even[last];
    double p1 = sum[c + 1] * even[0] * odd[last];
    double p2 = sum[c + 2] * odd[0] * even[last];
    double p3 = sum[c + 3] * odd[0] * odd[last];
    double left = random.fraction() * (p0 + p1 + p2 + p3);
    if (left < p0) {
      return 0;
    }
    if (left < p0 + p1) {
      return 1;
    }
    return left < p0 + p1 + p2 || p3 == 0 ? 2 : 3;
  }

  /**
   * Draws the apex on chord (i, j) given the parities at its ends.
   *
   * @return the apex k, and the parities on the chords (i, k) and (k, j), as 16k + 4(2a + x) + 2y +
   *     b
   */
  int drawApex(double[] px, double[] py, int i, int j, int ends) {
    double left = random.fraction() * sum[chord(i, j) + ends];
    int drawn = -1;
    long apexes = from[i] & into[j];
    while (apexes != 0 && left >= 0) {
      int k = Long.numberOfTrailingZeros(apexes);
      apexes &= apexes - 1;
      if (mesh.isLeftTurn(px[i], py[i], px[k], py[k], px[j], py[j])) {
        for (int xy = 0; xy < 4 && left >= 0; xy++) {
          int l = 2 * ((ends >> 1) ^ 1) + (xy >> 1);
          int r = 2 * (xy & 1) + ((ends & 1) ^ 1);
          boolean evenAtApex = xy == 1 || xy == 2; // x + 1 + y
          double p = sum[chord(i, k) + l] * sum[chord(k, j) + r] * (evenAtApex ? even[k] : odd[k]);
          if (p > 0) {
            left -= p;
            drawn = 16 * k + 4 * l + r;
          }
        }
      }
    }
    return drawn;
  }
}
