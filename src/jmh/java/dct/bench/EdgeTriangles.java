package dct.bench;

import dct.core.geometry.Predicates;

/** The triangular faces of a straight plane graph that is given by its edges only. */
final class EdgeTriangles {
  private final double[] x;
  private final double[] y;
  private final int[] first; // by vertex: where its neighbours begin
  private final int[] neighbour; // counter-clockwise round each vertex

  private EdgeTriangles(double[] x, double[] y, int[] ends) {
    this.x = x;
    this.y = y;
    first = new int[x.length + 1];
    for (int end : ends) {
      first[end + 1]++;
    }
    for (int v = 0; v < x.length; v++) {
      first[v + 1] += first[v];
    }
    neighbour = new int[ends.length];
    int[] place = first.clone();
    for (int k = 0; k < ends.length; k++) {
      neighbour[place[ends[k]]++] = ends[k ^ 1];
    }
    for (int v = 0; v < x.length; v++) {
      sortRound(v);
    }
  }

  /** The triangles, counter-clockwise; {@code ends} holds the two ends of each edge. */
  static int[] of(double[] x, double[] y, int[] ends) {
    return new EdgeTriangles(x, y, ends).triangles();
  }

  private void sortRound(int v) {
    for (int i = first[v] + 1; i < first[v + 1]; i++) {
      int u = neighbour[i];
      int j = i;
      for (; j > first[v] && precedes(v, u, neighbour[j - 1]); j--) {
        neighbour[j] = neighbour[j - 1];
      }
      neighbour[j] = u;
    }
  }

  private boolean precedes(int v, int a, int b) {
    boolean above = isAbove(v, a);
    return above == isAbove(v, b) ? turn(v, a, b) > 0 : above;
  }

  private boolean isAbove(int v, int u) {
    return y[u] > y[v] || (y[u] == y[v] && x[u] > x[v]);
  }

  private int turn(int a, int b, int c) {
    return Predicates.orient(x[a], y[a], x[b], y[b], x[c], y[c]);
  }

  private int[] triangles() {
    TriangleList triangles = new TriangleList(2 * x.length);
    for (int u = 0; u < x.length; u++) {
      for (int k = first[u]; k < first[u + 1]; k++) {
        int v = neighbour[k];
        int w = afterOnLeft(u, v);
        boolean closes = afterOnLeft(v, w) == u && afterOnLeft(w, u) == v;
        if (u < v && u < w && closes && turn(u, v, w) > 0) {
          triangles.add(u, v, w);
        }
      }
    }
    return triangles.toArray();
  }

  /** Where the boundary of the face on the left of the edge from u goes on from v. */
  private int afterOnLeft(int u, int v) {
    int k = first[v];
    while (neighbour[k] != u) {
      k++;
    }
    return neighbour[k == first[v] ? first[v + 1] - 1 : k - 1];
  }
}
