package dct.ui.document;

import java.util.Arrays;

/**
 * The vertices of a ring in order, kept as runs of successive numbers, which they mostly are: a
 * history holds a ring for each edit. Immutable.
 */
final class RingRuns {
  private final int[] bounds; // the first and the last number of each run
  private final int size;

  private RingRuns(int[] bounds, int size) {
    this.bounds = bounds;
    this.size = size;
  }

  /** A ring of these vertices. */
  static RingRuns of(int... vertices) {
    int[] bounds = new int[2 * vertices.length];
    int count = 0;
    for (int k = 0; k < vertices.length; k++) {
      if (k > 0 && vertices[k] == vertices[k - 1] + 1) {
        bounds[count - 1] = vertices[k];
      } else {
        bounds[count++] = vertices[k];
        bounds[count++] = vertices[k];
      }
    }
    return new RingRuns(Arrays.copyOf(bounds, count), vertices.length);
  }

  /** The ring of the vertices 0 … n − 1. */
  static RingRuns ofAll(int n) {
    return new RingRuns(n == 0 ? new int[0] : new int[] {0, n - 1}, n);
  }

  /** The number of vertices. */
  int size() {
    return size;
  }

  /** The first vertex, or −1. */
  int first() {
    return size == 0 ? -1 : bounds[0];
  }

  /** The last vertex, or −1. */
  int last() {
    return size == 0 ? -1 : bounds[bounds.length - 1];
  }

  /** The highest number, or −1. */
  int highest() {
    return Arrays.stream(bounds).max().orElse(-1);
  }

  /** The vertices in order. */
  int[] vertices() {
    int[] vertices = new int[size];
    int k = 0;
    for (int run = 0; run < bounds.length; run += 2) {
      for (int v = bounds[run]; v <= bounds[run + 1]; v++) {
        vertices[k++] = v;
      }
    }
    return vertices;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof RingRuns that && Arrays.equals(bounds, that.bounds);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(bounds);
  }

  @Override
  public String toString() {
    return Arrays.toString(bounds);
  }
}
