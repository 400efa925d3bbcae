package dct.core.degree.region;

import dct.core.degree.Preference;

/**
 * What a {@link MeshRegion} is worth by a {@link SecondCost}, and the table that finds its most
 * preferred triangulation.
 */
final class PreferredRegion {
  private final SearchMesh mesh;
  private final SecondCost second;
  private final PreferredRegionTable table;
  private final int[] site; // by place: the number of the vertex in triangulations

  /**
   * The same for regions of at most so many vertices.
   *
   * @param x by place: where the coordinates stand when a region is solved
   * @param costs by place: where its costs stand then, 0 or 1 each
   */
  PreferredRegion(
      SearchMesh mesh, Preference preference, double[] x, double[] y, int[] costs, int most) {
    this.mesh = mesh;
    site = new int[most];
    double longest = SecondCost.longest(mesh.x, mesh.y);
    int bits = SecondCost.bitsBeside(most);
    second = new SecondCost(preference, x, y, site, bits, longest);
    table = new PreferredRegionTable(mesh, x, y, costs, second, most);
  }

  /** Finds the most preferred of the triangulations with the fewest unmet vertices. */
  ChordTable solve(int[] ring, int size) {
    for (int i = 0; i < size; i++) {
      site[i] = mesh.site[ring[i]];
    }
    table.solve(size);
    return table;
  }

  /**
   * Whether what was found is better than the triangles that there are.
   *
   * @param slot the triangles, by their first half-edge
   * @param unmet how many vertices of the region are unmet now
   */
  boolean isBetter(int[] slot, int unmet) {
    int size = table.size();
    long largest = 0;
    long sum = 0;
    for (int k = 0; k < size - 2; k++) {
      int u = mesh.corner[slot[k]];
      int v = mesh.corner[slot[k] + 1];
      int w = mesh.corner[slot[k] + 2];
      largest = Math.max(largest, ofTriangle(u, v, w));
      sum += ofEdge(u, v) + ofEdge(v, w) + ofEdge(w, u);
    }
    for (int i = 0; i < size; i++) {
      sum -= second.ofChord(i, i + 1 == size ? 0 : i + 1);
    }
    long present = second.isLargest() ? largest : sum / 2 + second.ofChord(0, size - 1);
    return table.least() < table.cost(unmet, present);
  }

  private long ofTriangle(int u, int v, int w) {
    return second.ofTriangle(mesh.x[u], mesh.y[u], mesh.x[v], mesh.y[v], mesh.x[w], mesh.y[w]);
  }

  private long ofEdge(int u, int v) {
    return second.ofEdge(mesh.x[u] - mesh.x[v], mesh.y[u] - mesh.y[v], mesh.site[u], mesh.site[v]);
  }
}
