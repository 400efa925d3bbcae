package dct.core.triangulate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.dcel.Dcel;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import java.util.Arrays;

/**
 * The constrained Delaunay triangulation of a region (Lee and Lin 1986; Chew 1989): of all
 * triangulations with its ring edges and fixed edges the one where no vertex that is visible from
 * inside a triangle lies strictly inside the circle through its corners, ring edges and fixed edges
 * being opaque. Exactly so, for every region.
 *
 * <p>All vertices are triangulated as those of {@link Delaunay} are; then the ring edges and fixed
 * edges that are missing are inserted one after the other ({@link SegmentInsertion}) in a random
 * order that is always the same; at last all edges outside are taken out. An edge outside joins two
 * vertices of rings; at either end it lies on the other side of the ring's edges than the region,
 * by which it is known.
 *
 * <p>O(n log n) time for the Delaunay triangulation, and O(n) space. In a random order, m missing
 * edges are expected to cross O(n log² m) edges in all (Shewchuk and Brown 2015). Here the order is
 * random in rounds only, each as long as all before it, and in a round from place to neighbouring
 * place (Amenta, Choi and Rote 2003), so that what is near is still in the cache: as many edges are
 * crossed in measurements, in half the time. Looking for the triangles in which insertions start
 * adds little: the degrees that are the smaller ones at their edges sum up to three times all
 * degrees at most, in any plane graph. Each insertion takes as many steps more as its cavities ask
 * for, quadratic at worst in the size of one.
 *
 * <p>Among cocircular vertices the edge kept depends on the order, but not on the number of
 * threads. Edges are numbered from place to neighbouring place, those inserted with the numbers of
 * those that they crossed.
 */
public final class ConstrainedDelaunay {
  private static final long SEED = 1;

  private final Region region;
  private final Progress progress;
  private final int[] place; // by vertex: its place in the order of the triangulation
  private final DelaunayMerge merge;
  private final SegmentInsertion edges; // between places

  private ConstrainedDelaunay(Region region, Progress progress) {
    this.region = region;
    this.progress = progress;
    merge = new DelaunayMerge(region.points(), progress.part(0, 0.5));
    merge.run();
    int[] vertex = merge.order().site;
    place = new int[vertex.length];
    for (int p = 0; p < place.length; p++) {
      place[vertex[p]] = p;
    }
    edges = new SegmentInsertion(merge.placed(), merge.order(), progress);
  }

  /**
   * The constrained Delaunay triangulation. Its ring edges are those on the boundary, fixed edges
   * of the kind {@link EdgeKind#FIXED}.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Triangulation triangulate(Region region, Progress progress) {
    ConstrainedDelaunay run = new ConstrainedDelaunay(region, progress);
    run.insertMissing();
    int[] outer = run.takeOutside();
    progress.report(0.9, "Linking the edges");
    Dcel dcel = Dcel.of(region.size(), run.merge.links(), outer, progress);
    return Triangulation.of(region, dcel, edge -> EdgeKind.DIAGONAL);
  }

  // ---- the edges that must be there

  private void insertMissing() {
    long[] missing = inRounds(missing());
    Progress part = progress.part(0.5, 0.9);
    for (int k = 0; k < missing.length; k++) {
      Progress.tick(part, k, missing.length, "Inserting the edges");
      edges.insert((int) (missing[k] >> Integer.SIZE), (int) missing[k]);
    }
  }

  /** The places that ring edges and fixed edges join which are no edges yet, the smaller first. */
  private long[] missing() {
    Rings rings = region.rings();
    int ringEdges = region.positions();
    long[] missing = new long[ringEdges + rings.fixedCount()];
    int count = 0;
    for (int k = 0; k < missing.length; k++) {
      Progress.check(progress, k);
      boolean onRing = k < ringEdges;
      int j = k - ringEdges;
      int u = place[onRing ? region.vertex(k) : rings.fixedFrom(j)];
      int v = place[onRing ? region.vertex(region.after(k)) : rings.fixedTo(j)];
      if (!edges.has(u, v)) {
        missing[count++] = ((long) Math.min(u, v) << Integer.SIZE) | Math.max(u, v);
      }
    }
    return Arrays.copyOf(missing, count);
  }

  /** A random half comes last, a random half of the rest before it, and so on; each in order. */
  private static long[] inRounds(long[] missing) {
    Arrays.sort(missing);
    SeededRandom random = new SeededRandom(SEED);
    byte[] round = new byte[missing.length];
    int[] end = new int[Long.SIZE + 2]; // by round, the first one last
    for (int k = 0; k < round.length; k++) {
      round[k] = (byte) Long.numberOfTrailingZeros(random.nextLong());
      end[Long.SIZE - round[k] + 1]++;
    }
    for (int r = 1; r < end.length; r++) {
      end[r] += end[r - 1];
    }
    long[] ordered = new long[missing.length];
    for (int k = 0; k < round.length; k++) {
      ordered[end[Long.SIZE - round[k]]++] = missing[k];
    }
    return ordered;
  }

  // ---- the outside

  /**
   * Takes all edges outside the region out; returns a half-edge of each ring, outside on its left.
   */
  private int[] takeOutside() {
    int[] outer = new int[region.rings().count()];
    for (int k = 0; k < region.positions(); k++) {
      Progress.check(progress, k);
      int before = place[region.vertex(region.before(k))];
      int v = place[region.vertex(k)];
      int after = place[region.vertex(region.after(k))];
      int ringEdge = takeOutside(before, v, after);
      outer[region.rings().ringOf(region.vertex(k))] = ringEdge ^ 1;
    }
    return outer;
  }

  /**
   * Takes the edges at v out that lie counter-clockwise between those to the vertices before and
   * after it on its ring.
   *
   * @return the half-edge from v to the one after it
   */
  private int takeOutside(int before, int v, int after) {
    int[] origin = merge.placed().origin();
    int e = edges.out(v);
    while (origin[e ^ 1] != before) {
      e = edges.rotate(e);
    }
    e = edges.rotate(e);
    while (origin[e ^ 1] != after) {
      int following = edges.rotate(e);
      edges.remove(e);
      e = following;
    }
    return e;
  }
}
