package dct.render;

/**
 * The edges of a layer in the order of their nearer ends along the curve of a {@link SceneIndex}.
 */
final class IndexedEdges {
  private static final double SHORT = 1e-140; // the squares of shorter ones lose their digits

  private final Stroke stroke;
  private final int[] from; // the place of one end, by edge
  private final int[] to; // the place of the other
  private final Blocks blocks;
  private final double[] longest; // the length of the longest edge, by block

  /**
   * Sorts the edges of a layer by counting.
   *
   * @param places where each vertex is along the curve
   * @param x the x-coordinates along the curve
   * @param y the y-coordinates along the curve
   */
  IndexedEdges(EdgeLayer layer, int[] places, double[] x, double[] y) {
    stroke = layer.stroke();
    from = new int[layer.size()];
    to = new int[layer.size()];
    blocks = new Blocks(from.length);
    longest = new double[blocks.count()];
    sort(layer, places);
    for (int k = 0; k < from.length; k++) {
      int a = from[k];
      int b = to[k];
      blocks.include(k, x[a], y[a]);
      blocks.include(k, x[b], y[b]);
      longest[k / Blocks.SIZE] =
          Math.max(longest[k / Blocks.SIZE], length(x[a] - x[b], y[a] - y[b]));
    }
  }

  /** The length of a vector; a slower way where the squares of its parts are no numbers. */
  private static double length(double dx, double dy) {
    double length = Math.sqrt(dx * dx + dy * dy);
    return length > SHORT ? length : Math.hypot(dx, dy);
  }

  private void sort(EdgeLayer layer, int[] places) {
    int[] next = new int[places.length + 1]; // where the next edge of each place goes
    for (int k = 0; k < from.length; k++) {
      next[Math.min(places[layer.from(k)], places[layer.to(k)]) + 1]++;
    }
    for (int place = 1; place < next.length; place++) {
      next[place] += next[place - 1];
    }
    for (int k = 0; k < from.length; k++) {
      int a = places[layer.from(k)];
      int b = places[layer.to(k)];
      int at = next[Math.min(a, b)]++;
      from[at] = a;
      to[at] = b;
    }
  }

  /** How these edges are drawn. */
  Stroke stroke() {
    return stroke;
  }

  /** The blocks of the edges. */
  Blocks blocks() {
    return blocks;
  }

  /** The length of the longest edge in a block, in the model. */
  double longest(int block) {
    return longest[block];
  }

  /**
   * The edge between two places, in logarithmic time and that of looking at the edges of one place.
   *
   * @throws IllegalArgumentException if there is none
   */
  int find(int a, int b) {
    int nearer = Math.min(a, b);
    int low = 0;
    int high = from.length;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (Math.min(from[middle], to[middle]) < nearer) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    for (int k = low; k < from.length && Math.min(from[k], to[k]) == nearer; k++) {
      if (Math.max(from[k], to[k]) == Math.max(a, b)) {
        return k;
      }
    }
    throw new IllegalArgumentException("there is no edge between places " + a + " and " + b);
  }

  /** The place of one end of edge k. */
  int from(int k) {
    return from[k];
  }

  /** The place of the other end of edge k. */
  int to(int k) {
    return to[k];
  }
}
