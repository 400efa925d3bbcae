package dct.io.format;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Edges between numbered vertices, as those at the rim of a triangulation, and the rings that they
 * make where a vertex has two of them. Linear.
 */
public final class Rim {
  private static final int NONE = -1;

  private final int[] one; // a neighbour of each vertex along the rim
  private final int[] other; // its other neighbour
  private final boolean[] branches; // vertices with more than two
  private int edges;

  /** A rim without edges among so many vertices. */
  public Rim(int vertices) {
    one = new int[vertices];
    other = new int[vertices];
    branches = new boolean[vertices];
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
      branches[u] = true;
    }
  }

  /** How many edges there are. */
  public int edges() {
    return edges;
  }

  /** How many vertices there are. */
  public int vertices() {
    return one.length;
  }

  /** All vertices in order, from v0 on, if the edges are one ring through them; otherwise empty. */
  public int[] ring() {
    List<int[]> rings = edges == one.length ? rings() : List.of();
    return rings.size() == 1 && rings.get(0).length == one.length ? rings.get(0) : new int[0];
  }

  /** The rings of three vertices and more, in the order of their first vertices. */
  public List<int[]> rings() {
    List<int[]> rings = new ArrayList<>();
    boolean[] seen = new boolean[one.length];
    int[] walk = new int[one.length];
    for (int start = 0; start < one.length; start++) {
      int size = 0;
      int before = NONE;
      int v = start;
      while (!seen[v] && !branches[v] && other[v] != NONE) {
        seen[v] = true;
        walk[size++] = v;
        int next = one[v] == before ? other[v] : one[v];
        before = v;
        v = next;
      }
      if (v == start && size > 2) {
        rings.add(Arrays.copyOf(walk, size));
      }
    }
    return rings;
  }
}
