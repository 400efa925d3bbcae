package dct.core.degree.region;

import java.util.function.IntPredicate;

/**
 * How many edges of a {@link SearchMesh} there are from vertices to a target, by breadth-first
 * search: the distance in a region, where a straight way may lead through holes. It is that of the
 * mesh when it was asked for; what changes since then changes it little.
 */
final class Hops {
  private final SearchMesh mesh;
  private final int[] hops; // by vertex: 1 more than the distance from the target; 0 if not reached
  private final int[] queue; // vertices reached, in this order
  private int reached;
  private int farthest;
  private final VertexList spokes = new VertexList();

  Hops(SearchMesh mesh) {
    this.mesh = mesh;
    hops = new int[mesh.size()];
    queue = new int[mesh.size()];
  }

  /** The distance from v to the target; one more than any other if v was not reached. */
  int distance(int v) {
    return hops[v] == 0 ? farthest : hops[v] - 1;
  }

  /**
   * Measures the distances to a target as far as it takes to reach such a vertex, which is
   * returned, or NONE.
   */
  int search(int target, IntPredicate isSought) {
    for (int k = 0; k < reached; k++) {
      hops[queue[k]] = 0;
    }
    reached = 0;
    add(target, 1);
    int found = SearchMesh.NONE;
    for (int k = 0; k < reached && found == SearchMesh.NONE; k++) {
      int v = queue[k];
      mesh.collectEdges(v, spokes);
      for (int i = 0; i < spokes.size() && found == SearchMesh.NONE; i++) {
        int e = spokes.get(i);
        int w = mesh.corner[e] == v ? mesh.corner[SearchMesh.next(e)] : mesh.corner[e];
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
