package dct.core.degree.region;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.degree.Preference;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.VisibilityGraph;
import java.util.Arrays;
import java.util.concurrent.CancellationException;

/**
 * A simple polygon grown triangle by triangle in a {@link SearchMesh} and filled anew with the best
 * triangulation for the costs given: by a {@link RegionTable}, or a {@link ParityTable} if it has
 * many vertices.
 *
 * <p>The triangles taken are those of the mesh, each joined along one edge by a vertex that is new
 * to the region: so the region is a simple polygon with no vertex inside. Only vertices numbered
 * from {@code lo} to {@code hi} − 1 are taken. While it is open, the parities of the mesh are those
 * of the triangles outside it.
 *
 * <p>The present triangles are one of the choices, so that the number of unmet vertices never
 * grows. Growing costs O(m) a triangle, filling at most m³/6 steps for m vertices.
 */
final class MeshRegion {
  private static final long MOST_STEPS = 200_000_000L; // of one large table

  private final SearchMesh mesh;
  private final SeededRandom random;
  private final Progress progress;
  private final RegionTable small;
  private PreferredRegion preferred; // null if nothing is preferred
  private final int lo;
  private final int hi;
  private final int[] ring; // the vertices, counter-clockwise
  private final int[] outer; // by place: the half-edge outside, from the next vertex to this one
  private final int[] slot; // the triangles, size − 2 of them, by their first half-edge
  private final int[] costs; // by place: of an even number of triangles, and of an odd one
  private final double[] px;
  private final double[] py;
  private int size;
  private int before; // how many of the vertices were unmet when they were taken
  private int filled; // how many triangles are written

  MeshRegion(SearchMesh mesh, SeededRandom random, Progress progress, int most, int lo, int hi) {
    this.mesh = mesh;
    this.random = random;
    this.progress = progress;
    this.lo = lo;
    this.hi = hi;
    ring = new int[most];
    outer = new int[most];
    slot = new int[most];
    costs = new int[2 * most];
    px = new double[most];
    py = new double[most];
    small = new RegionTable(mesh, px, py, costs, Math.min(most, RegionTable.MOST));
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
      before += mesh.isUnmet(ring[i]) ? 1 : 0;
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

  /**
   * Grows to m vertices, or fewer where so many tries a vertex, at random edges, do not suffice.
   */
  void grow(int m, int triesEach) {
    for (int tries = triesEach * m; size < m && tries > 0; tries--) {
      tryTake(random.nextInt(size));
    }
  }

  /** Grows as {@link #grow}, each time over the better of two edges for coming near a target. */
  void growTowards(int target, int m, int triesEach) {
    for (int tries = triesEach * m; size < m && tries > 0; tries--) {
      int i = random.nextInt(size);
      int j = random.nextInt(size);
      tryTake(distanceBeyond(j, target) < distanceBeyond(i, target) ? j : i);
    }
  }

  private double distanceBeyond(int place, int target) {
    int e = outer[place];
    return e < 0 // there is none, or the edge is fixed
        ? Double.POSITIVE_INFINITY
        : mesh.away(mesh.corner[SearchMesh.prev(e)], target);
  }

  /** Takes the triangle beyond an edge if there is one and its apex is new and within bounds. */
  boolean tryTake(int place) {
    int e = outer[place];
    if (e < 0) { // there is none, or the edge is fixed
      return false;
    }
    int last = SearchMesh.prev(e);
    int apex = mesh.corner[last];
    if (!isMine(apex) || contains(apex)) {
      return false;
    }
    before += mesh.isUnmet(apex) ? 1 : 0;
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
   * Closes the region with the fewest unmet vertices; ties break at random.
   *
   * @param noiseBits chords cost a random amount below 2 to this power; all of them together less
   *     than a weight
   * @return by how much the number of unmet vertices grew: never above 0
   * @throws CancellationException if cancelled; then nothing has changed
   */
  int fill(int noiseBits) {
    for (int i = 0; i < size; i++) {
      setCost(i, mesh.weight[ring[i]]);
    }
    return replace(noiseBits);
  }

  /**
   * Closes the region with the fewest unmet vertices, and among such triangulations with one whose
   * unmet vertices are near a target.
   *
   * @param pull the price of the farthest vertex over the nearest, small against a weight
   * @return by how much the number of unmet vertices grew: never above 0
   */
  int fillTowards(int target, int pull, int noiseBits) {
    double nearest = Double.POSITIVE_INFINITY;
    double farthest = 0;
    for (int i = 0; i < size; i++) {
      px[i] =
          mesh.hops == null
              ? Math.sqrt(mesh.squaredDistance(ring[i], target))
              : mesh.hops.distance(ring[i]);
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
    costs[2 * i] = isWrong ? cost : 0;
    costs[2 * i + 1] = isWrong ? 0 : cost;
  }

  private int replace(int noiseBits) {
    locate();
    if (size <= RegionTable.MOST) {
      small.solve(size, noiseBits, random.nextInt());
      return write(small);
    }
    try {
      VisibilityGraph graph = visibility();
      if (ParityTable.steps(graph) <= MOST_STEPS) {
        return write(large(graph, noiseBits));
      }
    } catch (CancellationException e) {
      putBack();
      throw e;
    }
    putBack();
    return 0;
  }

  private void locate() {
    for (int i = 0; i < size; i++) {
      px[i] = mesh.x[ring[i]];
      py[i] = mesh.y[ring[i]];
    }
  }

  private VisibilityGraph visibility() {
    Points points = Points.of(Arrays.copyOf(px, size), Arrays.copyOf(py, size));
    SimplePolygon polygon = SimplePolygon.of(points, progress);
    return VisibilityGraph.of(
        polygon,
        MonotoneTriangulation.triangulate(polygon, progress),
        Integer.MAX_VALUE / 8,
        progress);
  }

  private ParityTable large(VisibilityGraph graph, int noiseBits) {
    int[] noise = new int[graph.pairs()];
    for (int pair = 0; pair < noise.length; pair++) {
      noise[pair] = random.nextInt(1 << noiseBits);
    }
    return ParityTable.fill(graph, costs, noise, progress);
  }

  /** Lets {@link #fillPreferred} prefer this. */
  void prefer(Preference preference) {
    int most = Math.min(ring.length, RegionTable.MOST);
    preferred = new PreferredRegion(mesh, preference, px, py, costs, most);
  }

  /**
   * Closes the region, which has few vertices, with the fewest unmet ones and of such
   * triangulations with the most preferred.
   *
   * @return whether it is better than before; if not, nothing has changed
   */
  boolean fillPreferred() {
    for (int i = 0; i < size; i++) {
      setCost(i, mesh.weight[ring[i]] == 0 ? 0 : 1);
    }
    locate();
    ChordTable table = preferred.solve(ring, size);
    boolean isBetter = preferred.isBetter(slot, before);
    if (isBetter) {
      write(table);
    } else {
      putBack();
    }
    return isBetter;
  }

  /** Closes the region with the triangles that it had. */
  private void putBack() {
    for (int k = 0; k < size - 2; k++) {
      for (int e = slot[k]; e < slot[k] + 3; e++) {
        mesh.wrong[mesh.corner[e]] ^= 1;
      }
    }
  }

  /** Closes the region as a table says; returns by how much the number of unmet vertices grew. */
  private int write(ChordTable table) {
    filled = 0;
    mesh.link(write(table, 0, size - 1, table.ends()), outer[size - 1]);
    return unmet() - before;
  }

  /** Writes the triangles on chord (i, j); returns the half-edge from j to i on its near side. */
  private int write(ChordTable table, int i, int j, int ends) {
    if (j == i + 1) {
      return outer[i];
    }
    int found = table.triangle(i, j, ends);
    int k = found >> 4;
    int t = slot[filled++];
    setCorner(t, ring[i]);
    setCorner(t + 1, ring[k]);
    setCorner(t + 2, ring[j]);
    mesh.link(t, write(table, i, k, (found >> 2) & 3));
    mesh.link(t + 1, write(table, k, j, found & 3));
    return t + 2;
  }

  private void setCorner(int e, int v) {
    mesh.corner[e] = v;
    mesh.out[v] = e;
    mesh.wrong[v] ^= 1;
  }

  private int unmet() {
    int count = 0;
    for (int i = 0; i < size; i++) {
      count += mesh.isUnmet(ring[i]) ? 1 : 0;
    }
    return count;
  }
}
