package dct.io.format;

import java.util.Arrays;

/** The edges at the rim of a triangulation, and the ring that they make. Linear. */
public final class Rim {
  private static final int NONE = -1;

  private final int[] one; // a neighbour of each vertex along the rim
  private final int[] other; // its other neighbour
  private int edges;
  private boolean branches; // a vertex has more than two

  /** A rim without edges among so many vertices. */
  public Rim(int vertices) {
    one = new int[vertices];
    other = new int[vertices];
    Arrays.fill(one, NONE);
    Arrays.fill(other, NONE);
  }

  /** Adds an edge between vertices that there are. */
  public void add(int u, int v) {
    edges++;
    link(u, v);
    link(v, u);
  }

  private void link(int u, int v) {
    if (one[u] == NONE) {
      one[u] = v;
    } else if (other[u] == NONE) {
      other[u] = v;
    } else {
      branches = true;
    }
  }

  /** All vertices in order, from v0 on, if the edges are one ring through them; otherwise empty. */
  public int[] ring() {
    int n = one.length;
    if (branches || edges != n || n == 0) {
      return new int[0];
    }
    int[] ring = new int[n];
    int before = other[0];
    int v = 0;
    for (int i = 0; i < n; i++) {
      if (i > 0 && v == 0) {
        return new int[0]; // there are several rings
      }
      ring[i] = v;
      int next = one[v] == before ? other[v] : one[v];
      before = v;
      v = next;
    }
    return ring;
  }
}
