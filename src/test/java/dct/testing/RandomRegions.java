package dct.testing;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/**
 * Seeded regions: triangles are taken out of a Delaunay triangulation, from its rim and from holes
 * that grow, so that what is left has rings that do not touch; sites are what lies inside, and some
 * of the edges inside are fixed. Vertices are in random order, rings run either way.
 */
public final class RandomRegions {
  private final Triangulation mesh;
  private final Dcel dcel;
  private final Random random;
  private final boolean[] out; // by face: taken out
  private final int[] ring; // by vertex: the number of boundary edges there, two at most
  private final List<int[]> rings = new ArrayList<>();

  private RandomRegions(Triangulation mesh, Random random) {
    this.mesh = mesh;
    this.dcel = mesh.dcel();
    this.random = random;
    out = new boolean[dcel.faceBound()];
    out[Dcel.OUTER] = true;
    ring = new int[mesh.vertexCount()];
    for (int edge = 0; edge < mesh.edgeCount(); edge++) {
      count(edge, dcel.isBoundary(edge) ? 1 : 0);
    }
  }

  /**
   * The rings of a region made from about n sites of a family.
   *
   * @param holes at most so many
   * @param fixed of 100 edges inside, so many are fixed
   */
  public static Rings make(RandomSets.Family family, int n, int holes, int fixed, long seed) {
    Sites sites = family.make(n, seed);
    if (sites.size() < 3 || sites.areOnOneLine()) {
      return make(RandomSets.families().get(0), Math.max(4, n), holes, fixed, seed);
    }
    Triangulation mesh = Delaunay.triangulate(sites, Progress.NONE);
    return new RandomRegions(mesh, new Random(seed)).rings(holes, fixed);
  }

  /** The same, which is one. */
  public static Region region(RandomSets.Family family, int n, int holes, int fixed, long seed) {
    return Region.of(make(family, n, holes, fixed, seed), Progress.NONE);
  }

  /**
   * The same rings, stretched along y, so that many of their edges are not Delaunay any more.
   *
   * @param factor a power of two, so that nothing is rounded
   */
  public static Rings stretched(Rings rings, double factor) {
    Points p = rings.points();
    double[] y = Arrays.stream(p.ys()).map(value -> value * factor).toArray();
    List<int[]> same = IntStream.range(0, rings.count()).mapToObj(rings::ring).toList();
    return Rings.of(Points.of(p.xs(), y), same, rings.fixed());
  }

  private void count(int edge, int change) {
    ring[mesh.from(edge)] += change;
    ring[mesh.to(edge)] += change;
  }

  private Rings rings(int holes, int fixed) {
    int faces = dcel.faceBound() - 1;
    int taken = 0;
    int wanted = random.nextInt(1 + faces / 2);
    for (int tries = 0; tries < 4 * faces && taken < wanted; tries++) {
      taken += takeFromRim(1 + random.nextInt(faces)) ? 1 : 0;
    }
    int made = 0;
    for (int tries = 0; tries < 20 * holes && made < holes; tries++) {
      made += startHole(1 + random.nextInt(faces)) ? 1 : 0;
    }
    for (int tries = 0; tries < faces; tries++) {
      takeFromRim(random.nextInt(3) == 0 ? 1 + random.nextInt(faces) : 1);
    }
    collectRings();
    return shuffled(fixed);
  }

  private boolean startHole(int face) {
    int e = dcel.faceEdge(face);
    int f = dcel.next(e);
    int g = dcel.next(f);
    if (out[face] || ring[dcel.origin(e)] + ring[dcel.origin(f)] + ring[dcel.origin(g)] > 0) {
      return false;
    }
    take(face);
    return true;
  }

  /**
   * Takes a triangle with one side on the rim and a corner inside, so that all rings stay simple.
   */
  private boolean takeFromRim(int face) {
    int e = dcel.faceEdge(face);
    for (int k = 0; k < 3 && !out[face]; k++) {
      boolean onlySide =
          out[dcel.face(e ^ 1)]
              && !out[dcel.face(dcel.next(e) ^ 1)]
              && !out[dcel.face(dcel.prev(e) ^ 1)];
      if (onlySide && ring[dcel.origin(dcel.prev(e))] == 0) {
        take(face);
        return true;
      }
      e = dcel.next(e);
    }
    return false;
  }

  private void take(int face) {
    out[face] = true;
    int e = dcel.faceEdge(face);
    for (int k = 0; k < 3; k++) {
      count(e >> 1, out[dcel.face(e ^ 1)] ? -1 : 1);
      e = dcel.next(e);
    }
  }

  private void collectRings() {
    boolean[] seen = new boolean[mesh.vertexCount()];
    int lowest = 0;
    for (int v = 1; v < seen.length; v++) {
      lowest = mesh.points().yxLess(v, lowest) ? v : lowest;
    }
    collectRing(lowest, seen);
    for (int v = 0; v < seen.length; v++) {
      if (ring[v] == 2 && !seen[v]) {
        collectRing(v, seen);
      }
    }
  }

  private void collectRing(int start, boolean[] seen) {
    List<Integer> found = new ArrayList<>();
    int v = start;
    do {
      found.add(v);
      seen[v] = true;
      v = afterOnRim(v);
    } while (v != start);
    if (random.nextBoolean()) {
      Collections.reverse(found);
    }
    rings.add(found.stream().mapToInt(Integer::intValue).toArray());
  }

  private int afterOnRim(int v) {
    int e = dcel.outEdge(v);
    while (out[dcel.face(e)] || !out[dcel.face(e ^ 1)]) {
      e = dcel.rotate(e);
    }
    return dcel.target(e);
  }

  private Rings shuffled(int fixed) {
    int n = mesh.vertexCount();
    List<Integer> order = new ArrayList<>();
    for (int v = 0; v < n; v++) {
      order.add(v);
    }
    Collections.shuffle(order, random);
    int[] number = new int[n];
    double[] x = new double[n];
    double[] y = new double[n];
    for (int k = 0; k < n; k++) {
      int v = order.get(k);
      number[v] = k;
      x[k] = mesh.points().x(v);
      y[k] = mesh.points().y(v);
    }
    List<int[]> renamed =
        rings.stream().map(r -> Arrays.stream(r).map(v -> number[v]).toArray()).toList();
    return Rings.of(Points.of(x, y), renamed, fixedEdges(fixed, number));
  }

  private int[] fixedEdges(int share, int[] number) {
    return IntStream.range(0, mesh.edgeCount())
        .filter(edge -> !out[dcel.face(2 * edge)] && !out[dcel.face(2 * edge + 1)])
        .filter(edge -> random.nextInt(100) < share)
        .flatMap(edge -> IntStream.of(number[mesh.from(edge)], number[mesh.to(edge)]))
        .toArray();
  }
}
