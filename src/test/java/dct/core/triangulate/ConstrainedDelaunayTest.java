package dct.core.triangulate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import dct.core.geometry.SimplicityCheck;
import dct.experiment.generate.PolygonShape;
import dct.testing.CancelledAfter;
import dct.testing.ConstrainedDelaunayOracle;
import dct.testing.Exact;
import dct.testing.RandomRegions;
import dct.testing.RandomSets;
import dct.testing.RandomSets.Family;
import dct.testing.TriangulationAssert;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Small regions against the definition, larger ones edge by edge.
 *
 * <pre>
 * Points points = Points.ofPairs(0, 0, 9, 0, 9, 9, 0, 9, 3, 3, 6, 3, 3, 6, 7, 7);
 * Rings rings = Rings.of(points, List.of(new int[] {0, 1, 2, 3}, new int[] {4, 5, 6}), 7, 3);
 * Region region = Region.of(rings, Progress.NONE);
 * Triangulation t = ConstrainedDelaunay.triangulate(region, Progress.NONE);
 * t.triangleCount(); // 9
 * t.count(EdgeKind.FIXED); // 1
 * </pre>
 */
class ConstrainedDelaunayTest {

  @Test
  void theExample() {
    Points points = Points.ofPairs(0, 0, 9, 0, 9, 9, 0, 9, 3, 3, 6, 3, 3, 6, 7, 7);
    Rings rings = Rings.of(points, List.of(new int[] {0, 1, 2, 3}, new int[] {4, 5, 6}), 7, 3);
    Triangulation t = check(Region.of(rings, Progress.NONE), "the example");
    assertThat(t.triangleCount()).isEqualTo(9);
    assertThat(t.count(EdgeKind.FIXED)).isEqualTo(1);
  }

  static List<Family> families() {
    return RandomSets.families();
  }

  @ParameterizedTest
  @MethodSource("families")
  void smallRegionsByTheDefinition(Family family) {
    for (int seed = 0; seed < (isSlow(family) ? 20 : 120); seed++) {
      int n = 4 + seed % 30;
      Region region = RandomRegions.region(family, n, seed % 4, seed % 26, seed);
      String what = "%s, n %d, seed %d".formatted(family, n, seed);
      Triangulation t = check(region, what);
      assertThat(ConstrainedDelaunayOracle.problem(t, region)).as(what).isEmpty();
    }
  }

  @ParameterizedTest
  @MethodSource("families")
  void largerRegions(Family family) {
    for (int seed = 0; seed < (isSlow(family) ? 1 : 6); seed++) {
      int n = isSlow(family) ? 100 : 50 << seed;
      Region region = RandomRegions.region(family, n, 2 * seed, 5 * seed, seed);
      check(region, "%s, n %d, seed %d".formatted(family, n, seed));
    }
  }

  /** Stretched, so that edges of rings and fixed ones are missing at first. */
  @ParameterizedTest
  @MethodSource("familiesWithRoom")
  void stretchedRegions(Family family) {
    for (int seed = 0; seed < (isSlow(family) ? 10 : 100); seed++) {
      Rings rings = RandomRegions.make(family, 10 + seed % 30, seed % 4, seed % 26, seed);
      Region region = Region.of(RandomRegions.stretched(rings, 8), Progress.NONE);
      String what = "%s, seed %d".formatted(family, seed);
      Triangulation t = check(region, what);
      assertThat(ConstrainedDelaunayOracle.problem(t, region)).as(what).isEmpty();
    }
    int n = isSlow(family) ? 60 : 2000;
    Rings large = RandomRegions.stretched(RandomRegions.make(family, n, 30, 10, 1), 16);
    check(Region.of(large, Progress.NONE), family + ", large");
  }

  /** Whether every decision takes decimals of a thousand digits. */
  private static boolean isSlow(Family family) {
    return family.name().startsWith("wide range") || family.name().startsWith("least");
  }

  /** Their edges cross many Delaunay edges: long chains, some with edges that hang into them. */
  @ParameterizedTest
  @EnumSource(PolygonShape.class)
  void polygonsOfEveryShape(PolygonShape shape) {
    for (int n : new int[] {4, 6, 8, 14, 22, 34}) {
      for (int seed = 1; seed <= 5; seed++) {
        Region region = Region.of(shape.generate(n, seed));
        String what = "%s, n %d, seed %d".formatted(shape, n, seed);
        Triangulation t = check(region, what);
        assertThat(ConstrainedDelaunayOracle.problem(t, region)).as(what).isEmpty();
      }
    }
    check(Region.of(shape.generate(2000, 1)), shape + ", 2000");
  }

  /** Those round which there is room for a triangle. */
  static List<Family> familiesWithRoom() {
    return families().stream().filter(family -> !family.name().startsWith("least")).toList();
  }

  /** A long fixed edge over a sea of sites, so that both cavities are large. */
  @ParameterizedTest
  @MethodSource("familiesWithRoom")
  void fixedEdgesThatCrossMuch(Family family) {
    for (int seed = 0; seed < (isSlow(family) ? 5 : 40); seed++) {
      Region region = withLongEdges(family.make(5 + seed % 25, seed).points(), seed);
      String what = "%s, seed %d".formatted(family, seed);
      Triangulation t = check(region, what);
      assertThat(ConstrainedDelaunayOracle.problem(t, region)).as(what).isEmpty();
    }
  }

  /** A triangle round all sites, and as many random fixed edges as do not cross. */
  private static Region withLongEdges(Points sites, int seed) {
    int n = sites.size();
    double most = 1;
    for (int v = 0; v < n; v++) {
      most = Math.max(most, Math.max(Math.abs(sites.x(v)), Math.abs(sites.y(v))));
    }
    double far = 8 * most;
    Points points =
        sites.inserted(n, -far, -far).inserted(n + 1, far, -far).inserted(n + 2, 0, far);
    List<int[]> outer = List.of(new int[] {n, n + 1, n + 2});
    Random random = new Random(seed);
    Rings rings = Rings.of(points, outer);
    int[] fixed = new int[0];
    for (int tries = 0; tries < 3 * n; tries++) {
      int[] more = Arrays.copyOf(fixed, fixed.length + 2);
      more[fixed.length] = random.nextInt(n);
      more[fixed.length + 1] = random.nextInt(n);
      Rings tried = Rings.of(points, outer, more);
      if (SimplicityCheck.firstDefect(tried, Progress.NONE).isEmpty()) {
        fixed = more;
        rings = tried;
      }
    }
    return Region.of(rings, Progress.NONE);
  }

  // ---- what holds of all

  private static Triangulation check(Region region, String what) {
    Triangulation t = ConstrainedDelaunay.triangulate(region, Progress.NONE);
    TriangulationAssert.assertThat(t)
        .as(what)
        .isTriangulationOf(region)
        .hasInnerEdgesOnlyOf(EdgeKind.FIXED, EdgeKind.DIAGONAL);
    checkEdges(t, what);
    return t;
  }

  private static long key(int u, int v) {
    return ((long) Math.min(u, v) << 32) | Math.max(u, v);
  }

  /** No edge between two triangles but a fixed one has an apex inside the circle of the other. */
  private static void checkEdges(Triangulation t, String what) {
    Dcel dcel = t.dcel();
    for (int edge = 0; edge < t.edgeCount(); edge++) {
      if (t.kind(edge) == EdgeKind.DIAGONAL) {
        int c = dcel.origin(dcel.prev(2 * edge));
        int d = dcel.origin(dcel.prev(2 * edge + 1));
        assertThat(Exact.inCircle(t.points(), t.from(edge), t.to(edge), c, d))
            .as("%s, v%d–v%d", what, t.from(edge), t.to(edge))
            .isNotPositive();
      }
    }
  }

  /** The definition finds fault with ears that were cut off where an edge does, and only there. */
  @Test
  void theDefinitionAgreesWithTheEdges() {
    int faulty = 0;
    for (int seed = 0; seed < 60; seed++) {
      Rings rings = RandomRegions.make(families().get(1), 8 + seed % 20, seed % 4, 20, seed);
      Region region = Region.of(rings, Progress.NONE);
      Triangulation ears = EarClipping.triangulate(region, Progress.NONE);
      boolean isFaulty = ConstrainedDelaunayOracle.problem(ears, region).isPresent();
      boolean edgeIsFaulty = catchThrowable(() -> checkEdges(ears, "ears")) != null;
      assertThat(isFaulty).as("seed %d", seed).isEqualTo(edgeIsFaulty);
      faulty += isFaulty ? 1 : 0;
    }
    assertThat(faulty).isPositive();
  }

  // ---- what it depends on

  @Test
  void theNumbersOfTheVerticesMakeNoDifference() {
    Family uniform = families().get(0);
    for (int seed = 0; seed < 20; seed++) {
      Rings rings = RandomRegions.stretched(RandomRegions.make(uniform, 300, 4, 10, seed), 8);
      int[] number =
          new Random(seed)
              .ints(0, rings.points().size())
              .distinct()
              .limit(rings.points().size())
              .toArray();
      Triangulation t = triangulate(rings);
      long[] renamed =
          IntStream.range(0, t.edgeCount())
              .mapToLong(edge -> key(number[t.from(edge)], number[t.to(edge)]))
              .sorted()
              .toArray();
      assertThat(sortedEdges(triangulate(renumbered(rings, number)))).isEqualTo(renamed);
    }
  }

  private static Triangulation triangulate(Rings rings) {
    return ConstrainedDelaunay.triangulate(Region.of(rings, Progress.NONE), Progress.NONE);
  }

  private static Rings renumbered(Rings rings, int[] number) {
    double[] x = new double[number.length];
    double[] y = new double[number.length];
    for (int v = 0; v < number.length; v++) {
      x[number[v]] = rings.points().x(v);
      y[number[v]] = rings.points().y(v);
    }
    List<int[]> renamed =
        IntStream.range(0, rings.count())
            .mapToObj(r -> Arrays.stream(rings.ring(r)).map(v -> number[v]).toArray())
            .toList();
    int[] fixed = Arrays.stream(rings.fixed()).map(v -> number[v]).toArray();
    return Rings.of(Points.of(x, y), renamed, fixed);
  }

  private static long[] sortedEdges(Triangulation t) {
    return IntStream.range(0, t.edgeCount())
        .mapToLong(edge -> key(t.from(edge), t.to(edge)))
        .sorted()
        .toArray();
  }

  /** The vertices are triangulated in parallel; the result is the same with one thread. */
  @Test
  void theNumberOfThreadsMakesNoDifference() throws Exception {
    Region region = Region.of(PolygonShape.TOUR.generate(30_000, 1));
    List<String> many = edges(region);
    ForkJoinPool one = new ForkJoinPool(1);
    List<String> single = one.submit(() -> edges(region)).get();
    one.shutdown();
    assertThat(single).isEqualTo(many);
  }

  /** In the order of their numbers. */
  private static List<String> edges(Region region) {
    Triangulation t = ConstrainedDelaunay.triangulate(region, Progress.NONE);
    return IntStream.range(0, t.edgeCount()).mapToObj(e -> t.from(e) + "–" + t.to(e)).toList();
  }

  @Test
  void canBeCancelledAtAnyTime() {
    Region region = Region.of(PolygonShape.STAR_SHAPED.generate(20_000, 1));
    for (int questions = 0; questions < 20; questions++) {
      Progress progress = new CancelledAfter(questions);
      assertThatThrownBy(() -> ConstrainedDelaunay.triangulate(region, progress))
          .isInstanceOf(CancellationException.class);
    }
  }
}
