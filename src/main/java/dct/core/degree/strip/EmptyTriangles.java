package dct.core.degree.strip;

import dct.core.degree.region.SearchMesh;
import java.util.Arrays;

/**
 * The triangles with no other vertex in them or on them, among some vertices of a mesh, as a sweep
 * asks for them; each answer is computed once. Vertices are named by their rank in the order of the
 * sweep; left of an edge from a lower to a higher rank is above it.
 */
final class EmptyTriangles {
  private static final int BITS = 21; // of a rank

  private final SearchMesh mesh;
  private final int[] vertex; // by rank
  private final LongIndex edges = new LongIndex();
  private int[][] apexes = new int[64][]; // by number of the edge
  private boolean[] waits = new boolean[64]; // by number of the edge
  private final LongIndex corners = new LongIndex(); // three ranks that turn to the left
  private boolean[] free = new boolean[64]; // by number of the three

  /** The triangles among these vertices, which are in the order of a sweep. */
  EmptyTriangles(SearchMesh mesh, int[] vertex) {
    this.mesh = mesh;
    this.vertex = vertex;
  }

  private boolean isLeft(int a, int b, int c) {
    int u = vertex[a];
    int v = vertex[b];
    int w = vertex[c];
    return mesh.isLeftTurn(mesh.x[u], mesh.y[u], mesh.x[v], mesh.y[v], mesh.x[w], mesh.y[w]);
  }

  private static long key(int a, int b) {
    return (long) a << BITS | b;
  }

  /**
   * The number of the edge from a to b, by which to ask for it. O(k²) time for k ranks between when
   * it is new, near k log k as a rule.
   */
  int edge(int a, int b) {
    int known = edges.size();
    int edge = edges.number(key(a, b));
    if (edge == known) {
      if (known == apexes.length) {
        apexes = Arrays.copyOf(apexes, 2 * known);
        waits = Arrays.copyOf(waits, 2 * known);
      }
      apexes[edge] = findApexes(a, b);
      waits[edge] = findWait(a, b);
    }
    return edge;
  }

  /** The ranks between the ends of an edge that span an empty triangle above it. */
  int[] apexesAbove(int edge) {
    return apexes[edge];
  }

  /** Whether some c beyond its ends turns to the left of an edge and spans an empty triangle. */
  boolean canWait(int edge) {
    return waits[edge];
  }

  private int[] findApexes(int a, int b) {
    int[] found = new int[b - a];
    int above = 0;
    for (int c = a + 1; c < b; c++) {
      if (isLeft(a, b, c)) {
        found[above++] = c;
      }
    }
    sortByAngle(a, found, above);
    // One is an apex if its angle seen from b is smaller than that of all with a smaller one at a.
    int size = 0;
    for (int i = 0; i < above; i++) {
      if (size == 0 || isLeft(b, found[size - 1], found[i])) {
        found[size++] = found[i];
      }
    }
    return Arrays.copyOf(found, size);
  }

  /** Sorts ranks by their angles seen from a, the nearer of two on one ray first: Shell's sort. */
  private void sortByAngle(int a, int[] ranks, int size) {
    for (int gap = size / 2; gap > 0; gap /= 2) {
      for (int i = gap; i < size; i++) {
        int c = ranks[i];
        int k = i;
        while (k >= gap && isSooner(a, c, ranks[k - gap])) {
          ranks[k] = ranks[k - gap];
          k -= gap;
        }
        ranks[k] = c;
      }
    }
  }

  private boolean isSooner(int a, int c, int d) {
    return isLeft(a, c, d) || (c < d && !isLeft(a, d, c));
  }

  /** Whether a &lt; b &lt; c turn to the left at b and span an empty triangle. */
  boolean canCut(int a, int b, int c) {
    return isLeft(a, b, c) && isKnownFree(a, b, c);
  }

  private boolean isKnownFree(int a, int b, int c) {
    int known = corners.size();
    int three = corners.number(key(a, b) << BITS | c);
    if (three == known) {
      free = known < free.length ? free : Arrays.copyOf(free, 2 * known);
      free[three] = isFree(a, b, c);
    }
    return free[three];
  }

  private boolean isFree(int a, int b, int c) {
    for (int d = a + 1; d < c; d++) {
      boolean isInside = !isLeft(a, c, d) && !isLeft(b, a, d) && !isLeft(c, b, d);
      if (d != b && isInside) {
        return false;
      }
    }
    return true;
  }

  private boolean findWait(int a, int b) {
    int lowest = SearchMesh.NONE; // seen from a; if its triangle is not empty, none is
    for (int c = b + 1; c < vertex.length; c++) {
      if (isLeft(a, b, c) && (lowest == SearchMesh.NONE || isLeft(a, c, lowest))) {
        lowest = c;
      }
    }
    return lowest != SearchMesh.NONE && canCut(a, b, lowest);
  }
}
