package dct.core.degree.region;

import java.util.function.IntPredicate;

/**
 * How many edges of a mesh there are from vertices to a target, by breadth-first search: the
 * distance in a region, where a straight way may lead through holes. It is that of the mesh when it
 * was asked for; what changes since then changes it little.
 */
final class Hops {
  private static final int NONE = -1; // in place of a vertex

  private final Neighbours neighbours;
  private final int[] hops; // by vertex: 1 more than the distance from the target; 0 if not reached
  private final int[] queue; // vertices reached, in this order
  private int reached;
  private int farthest;
  private final VertexList around = new VertexList();

  /** Lists the vertices that have an edge with one. */
  @FunctionalInterface
  interface Neighbours {
    void collect(int v, VertexList neighbours);
  }

  /** Of a mesh of so many vertices. */
  Hops(int size, Neighbours neighbours) {
    this.neighbours = neighbours;
    hops = new int[size];
    queue = new int[size];
  }

  /** The distance from v to the target; one more than any other if v was not reached. */
  int distance(int v) {
    return hops[v] == 0 ? farthest : hops[v] - 1;
  }

  /**
   * Measures the distances to a target as far as it takes to reach such a vertex, which is
   * returned, or −1.
   */
  int search(int target, IntPredicate isSought) {
    for (int k = 0; k < reached; k++) {
      hops[queue[k]] = 0;
    }
    reached = 0;
    add(target, 1);
    int found = NONE;
    for (int k = 0; k < reached && found == NONE; k++) {
      int v = queue[k];
      neighbours.collect(v, around);
      for (int i = 0; i < around.size() && found == NONE; i++) {
        int w = around.get(i);
        if (hops[w] == 0) {
          add(w, hops[v] + 1);
          found = isSought.test(w) ? w : found;
        }
      }
    }
    farthest = hops[queue[reached - 1]];
    return found;
  }

  private void add(int v, int hop) {
    hops[v] = hop;
    queue[reached++] = v;
  }
}
