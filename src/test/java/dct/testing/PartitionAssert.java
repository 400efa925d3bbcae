package dct.testing;

import dct.core.dcel.Dcel;
import dct.core.dcel.DcelValidator;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Partition;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.Predicate;
import org.assertj.core.api.AbstractAssert;

/** Checks partitions of polygons independently of the code that makes them. */
public final class PartitionAssert extends AbstractAssert<PartitionAssert, Partition> {
  private static final int MOST_FOR_ORACLE = 200;

  private PartitionAssert(Partition actual) {
    super(actual, PartitionAssert.class);
  }

  /** The entry point. */
  public static PartitionAssert assertThat(Partition actual) {
    return new PartitionAssert(actual);
  }

  /** The pieces as cycles of vertex numbers, read from the topology. */
  public static List<int[]> rings(Partition partition) {
    Dcel dcel = partition.dcel();
    List<int[]> rings = new ArrayList<>();
    for (int f = 0; f < dcel.faceBound(); f++) {
      if (f != Dcel.OUTER && dcel.hasFace(f)) {
        rings.add(ring(dcel, dcel.faceEdge(f)));
      }
    }
    return rings;
  }

  private static int[] ring(Dcel dcel, int start) {
    List<Integer> ring = new ArrayList<>();
    int e = start;
    do {
      ring.add(dcel.origin(e));
      e = dcel.next(e);
    } while (e != start);
    return ring.stream().mapToInt(Integer::intValue).toArray();
  }

  /**
   * The pieces are simple and counter-clockwise, their sides are each boundary edge once and each
   * diagonal in both directions, and their areas add up.
   */
  public PartitionAssert isPartitionOf(SimplePolygon polygon) {
    isNotNull();
    DcelValidator.validate(actual.dcel());
    Points points = polygon.points();
    List<int[]> rings = rings(actual);
    int edges = actual.dcel().edgeCount();
    check(edges - polygon.size() == rings.size() - 1, "%d edges, %d pieces", edges, rings.size());
    checkSides(polygon, rings);
    ExactArea area = new ExactArea(points);
    BigInteger sum = BigInteger.ZERO;
    for (int[] ring : rings) {
      BigInteger doubled = area.ofRing(ring);
      check(doubled.signum() > 0, "piece %s is not counter-clockwise", Arrays.toString(ring));
      checkSimple(points, ring);
      sum = sum.add(doubled);
    }
    check(sum.equals(area.ofRing(all(points.size())).abs()), "the areas do not add up");
    return this;
  }

  private void checkSimple(Points points, int[] ring) {
    if (ring.length <= MOST_FOR_ORACLE) {
      boolean simple = SimplicityOracle.isSimple(RandomPolygons.select(points, ring));
      check(simple, "piece %s is not simple", Arrays.toString(ring));
    }
  }

  private static int[] all(int n) {
    int[] ring = new int[n];
    Arrays.setAll(ring, i -> i);
    return ring;
  }

  private void checkSides(SimplePolygon polygon, List<int[]> rings) {
    List<Long> sides = new ArrayList<>();
    for (int[] ring : rings) {
      for (int k = 0; k < ring.length; k++) {
        sides.add(((long) ring[k] << 32) | ring[(k + 1) % ring.length]);
      }
    }
    sides.sort(null);
    int alone = 0;
    for (int k = 0; k < sides.size(); k++) {
      long side = sides.get(k);
      check(k == 0 || side != sides.get(k - 1), "side v%d–v%d twice", side >> 32, (int) side);
      long twin = (side << 32) | (side >>> 32);
      if (Collections.binarySearch(sides, twin) < 0) {
        check(isBoundary(polygon.size(), side), "v%d–v%d has one side", side >> 32, (int) side);
        alone++;
      }
    }
    check(alone == polygon.size(), "%d boundary edges", alone);
  }

  private static boolean isBoundary(int n, long side) {
    int difference = Math.abs((int) (side >> 32) - (int) side);
    return difference == 1 || difference == n - 1;
  }

  /** Each piece has one highest and one lowest vertex in the order by y, then x. */
  public PartitionAssert hasMonotonePieces() {
    return eachRing(ring -> summits(ring) == 1, "is not monotone");
  }

  private int summits(int[] ring) {
    int summits = 0;
    for (int k = 0; k < ring.length; k++) {
      int before = ring[(k + ring.length - 1) % ring.length];
      int after = ring[(k + 1) % ring.length];
      summits += isBelow(before, ring[k]) && isBelow(after, ring[k]) ? 1 : 0;
    }
    return summits;
  }

  private boolean isBelow(int v, int w) {
    Points p = actual.region().points();
    return p.y(v) < p.y(w) || (p.y(v) == p.y(w) && p.x(v) < p.x(w));
  }

  /** Each piece turns strictly left at every vertex, once round. */
  public PartitionAssert hasStrictlyConvexPieces() {
    return eachRing(
        ring -> summits(ring) == 1 && isStrictlyConvex(actual.region().points(), ring),
        "is not strictly convex");
  }

  /** Whether the ring turns left at every vertex. */
  static boolean isStrictlyConvex(Points p, int[] ring) {
    int n = ring.length;
    for (int k = 0; k < n; k++) {
      if (Exact.orient(p, ring[k], ring[(k + 1) % n], ring[(k + 2) % n]) <= 0) {
        return false;
      }
    }
    return true;
  }

  private PartitionAssert eachRing(Predicate<int[]> law, String problem) {
    isNotNull();
    for (int[] ring : rings(actual)) {
      check(law.test(ring), "piece %s " + problem, Arrays.toString(ring));
    }
    return this;
  }

  private void check(boolean holds, String problem, Object... arguments) {
    if (!holds) {
      failWithMessage(problem, arguments);
    }
  }
}
