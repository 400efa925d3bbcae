package dct.core.degree.region;

import dct.core.SeededRandom;

/**
 * A simple polygon of a few vertices, grown triangle by triangle in a {@link SearchMesh} and filled
 * anew with the best triangulation for the costs given.
 *
 * <p>The triangles taken are those of the mesh, each joined along one edge by a vertex that is new
 * to the region: so the region is a simple polygon with no vertex inside. Only vertices numbered
 * from {@code lo} to {@code hi} − 1 are taken. While it is open, the parities of the mesh are those
 * of the triangles outside it.
 *
 * <p>Growing costs O(m) a triangle, filling O(m³) for m vertices.
 */
final class MeshRegion {
  private static final int NOISE_BITS = 10;

  private final SearchMesh mesh;
  private final SeededRandom random;
  private final RegionTable table;
  private final int lo;
  private final int hi;
  private final int[] ring; // the vertices, counter-clockwise
  private final int[] outer; // by place: the half-edge outside, from the next vertex to this one
  private final int[] slot; // the triangles, size − 2 of them, by their first half-edge
  private final double[] px;
  private final double[] py;
  private int size;
  private int before; // how many of the vertices were unsatisfied when they were taken
  private int filled; // how many triangles are written

  MeshRegion(SearchMesh mesh, SeededRandom random, int most, int lo, int hi) {
    this.mesh = mesh;
    this.random = random;
    this.lo = lo;
    this.hi = hi;
    table = new RegionTable(mesh, most);
    ring = new int[most];
    outer = new int[most];
    slot = new int[most];
    px = new double[most];
    py = new double[most];
  }

  /** The number of vertices. */
  int size() {
    return size;
  }

  /** The vertex at a place of the boundary, counter-clockwise. */
  int vertex(int place) {
    return ring[place];
  }

  /** Begins with the triangle of half-edge e; false, with nothing done, if it is out of bounds. */
  boolean open(int e) {
    int t = e & ~3;
    size = 0;
    if (!isMine(mesh.corner[t]) || !isMine(mesh.corner[t + 1]) || !isMine(mesh.corner[t + 2])) {
      return false;
    }
    for (int i = 0; i < 3; i++) {
      ring[i] = mesh.corner[t + i];
      outer[i] = mesh.twin[t + i];
    }
    before = 0;
    for (int i = 0; i < 3; i++) {
      before += mesh.isUnsatisfied(ring[i]) ? 1 : 0;
    }
    size = 3;
    take(t, ring[0], ring[1], ring[2]);
    return true;
  }

  private boolean isMine(int v) {
    return v >= lo && v < hi;
  }

  private void take(int t, int u, int v, int w) {
    slot[size - 3] = t;
    mesh.wrong[u] ^= 1;
    mesh.wrong[v] ^= 1;
    mesh.wrong[w] ^= 1;
  }

  /** Grows to m vertices, or fewer where that fails, over edges chosen at random. */
  void grow(int m) {
    for (int tries = 3 * m; size < m && tries > 0; tries--) {
      tryTake(random.nextInt(size));
    }
  }

  /** Grows as {@link #grow}, each time over the better of two edges for coming near a target. */
  void growTowards(int target, int m) {
    for (int tries = 3 * m; size < m && tries > 0; tries--) {
      int i = random.nextInt(size);
      int j = random.nextInt(size);
      tryTake(distanceBeyond(j, target) < distanceBeyond(i, target) ? j : i);
    }
  }

  private double distanceBeyond(int place, int target) {
    int e = outer[place];
    return e == SearchMesh.NONE
        ? Double.POSITIVE_INFINITY
        : mesh.squaredDistance(mesh.corner[SearchMesh.prev(e)], target);
  }

  /** Takes the triangle beyond an edge if there is one and its apex is new and within bounds. */
  boolean tryTake(int place) {
    int e = outer[place];
    if (e == SearchMesh.NONE) {
      return false;
    }
    int last = SearchMesh.prev(e);
    int apex = mesh.corner[last];
    if (!isMine(apex) || contains(apex)) {
      return false;
    }
    before += mesh.isUnsatisfied(apex) ? 1 : 0;
    size++;
    take(e & ~3, mesh.corner[e], ring[place], apex);
    for (int i = size - 1; i > place + 1; i--) {
      ring[i] = ring[i - 1];
      outer[i] = outer[i - 1];
    }
    ring[place + 1] = apex;
    outer[place + 1] = mesh.twin[last];
    outer[place] = mesh.twin[SearchMesh.next(e)];
    return true;
  }

  /** Whether v is a vertex of the region. */
  boolean contains(int v) {
    for (int i = 0; i < size; i++) {
      if (ring[i] == v) {
        return true;
      }
    }
    return false;
  }

  /**
   * Closes the region with the fewest unsatisfied vertices; ties break at random.
   *
   * @return by how much the number of unsatisfied vertices grew: never above 0
   */
  int fill() {
    for (int i = 0; i < size; i++) {
      setCost(i, mesh.weight[ring[i]]);
    }
    return replace(NOISE_BITS);
  }

  /**
   * Closes the region with the fewest unsatisfied vertices, and among such triangulations with one
   * whose unsatisfied vertices are near a target.
   *
   * @param pull the price of the farthest vertex over the nearest, small against a weight
   * @return by how much the number of unsatisfied vertices grew: never above 0
   */
  int fillTowards(int target, int pull, int noiseBits) {
    double nearest = Double.POSITIVE_INFINITY;
    double farthest = 0;
    for (int i = 0; i < size; i++) {
      px[i] = Math.sqrt(mesh.squaredDistance(ring[i], target));
      nearest = Math.min(nearest, px[i]);
      farthest = Math.max(farthest, px[i]);
    }
    double scale = pull / Math.max(farthest - nearest, Double.MIN_NORMAL);
    for (int i = 0; i < size; i++) {
      int weight = mesh.weight[ring[i]];
      setCost(i, weight == 0 ? 0 : weight + (int) ((px[i] - nearest) * scale));
    }
    return replace(noiseBits);
  }

  private void setCost(int i, int cost) {
    boolean isWrong = mesh.wrong[ring[i]] != 0;
    table.even[i] = isWrong ? cost : 0;
    table.odd[i] = isWrong ? 0 : cost;
  }

  private int replace(int noiseBits) {
    locate();
    table.solve(px, py, size, noiseBits, random.nextInt());
    filled = 0;
    mesh.link(write(0, size - 1, table.ends()), outer[size - 1]);
    return unsatisfied() - before;
  }

  private void locate() {
    for (int i = 0; i < size; i++) {
      px[i] = mesh.x[ring[i]];
      py[i] = mesh.y[ring[i]];
    }
  }

  /** Writes the triangles on chord (i, j); returns the half-edge from j to i on its near side. */
  private int write(int i, int j, int ends) {
    if (j == i + 1) {
      return outer[i];
    }
    int found = table.apex(px, py, i, j, ends);
    int k = found >> 4;
    int t = slot[filled++];
    setCorner(t, ring[i]);
    setCorner(t + 1, ring[k]);
    setCorner(t + 2, ring[j]);
    mesh.link(t, write(i, k, (found >> 2) & 3));
    mesh.link(t + 1, write(k, j, found & 3));
    return t + 2;
  }

  private void setCorner(int e, int v) {
    mesh.corner[e] = v;
    mesh.out[v] = e;
    mesh.wrong[v] ^= 1;
  }

  private int unsatisfied() {
    int count = 0;
    for (int i = 0; i < size; i++) {
      count += mesh.isUnsatisfied(ring[i]) ? 1 : 0;
    }
    return count;
  }
}
