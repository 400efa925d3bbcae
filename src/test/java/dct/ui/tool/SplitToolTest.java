package dct.ui.tool;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.SimplicityCheck;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.render.Viewport;
import java.math.BigDecimal;
import java.util.BitSet;
import java.util.Random;
import java.util.function.DoubleSupplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Where Split Vertex puts the new vertex. */
class SplitToolTest {

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void aVertexIsPutExactlyOnAnEdgeOfWholeCoordinates(long seed) {
    Random random = new Random(seed);
    for (int i = 0; i < 40; i++) {
      Points triangle = triangle(() -> random.nextInt(1000));
      FakeContext context = context(Domain.POLYGON, triangle);
      context.viewport = Viewport.IDENTITY.zoomed(Math.pow(2, random.nextInt(9) - 4), 500, 350);
      int edge = random.nextInt(3);
      split(context, edge, (1 + random.nextInt(98)) / 100.0);
      if (context.points().size() == 4) {
        assertThat(cross(triangle, edge, context.points(), edge + 1)).as("seed %d", seed).isZero();
      } else {
        assertThat(context.said).contains("is already there");
      }
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {11, 12, 13, 14})
  void wherePlacesAreRoundedThePolygonStaysSimple(long seed) {
    Random random = new Random(seed);
    int rounded = 0;
    for (int i = 0; i < 40; i++) {
      FakeContext context = context(Domain.POLYGON, triangle(() -> random.nextInt(9999) / 10.0));
      for (int k = 0; k < 4; k++) {
        split(context, random.nextInt(context.points().size()), 0.1 + 0.8 * random.nextDouble());
        rounded += context.said.contains("rounding") ? 1 : 0;
      }
      assertThat(SimplicityCheck.firstDefect(context.points(), Progress.NONE))
          .as("seed %d, %d", seed, i)
          .isEmpty();
    }
    assertThat(rounded).isPositive();
  }

  @ParameterizedTest
  @ValueSource(longs = {21, 22, 23, 24})
  void aSiteOnTheHullStaysOnTheHullAsDoAllOthers(long seed) {
    Random random = new Random(seed);
    for (int i = 0; i < 60; i++) {
      double digits = i % 2 == 0 ? 1 : 10;
      double[] pairs =
          random.ints(24, 0, (int) (1000 * digits)).mapToDouble(c -> c / digits).toArray();
      FakeContext context = context(Domain.SITES, Points.ofPairs(pairs));
      Triangulation before = delaunay(context.points());
      int edge = boundaryEdge(before, random);
      splitEdge(context, before.from(edge), before.to(edge), 0.2 + 0.6 * random.nextDouble());
      Triangulation after = delaunay(context.points());
      int added = after.vertexCount() - before.vertexCount();
      assertThat(after.count(EdgeKind.BOUNDARY))
          .as("seed %d, %d", seed, i)
          .isEqualTo(before.count(EdgeKind.BOUNDARY) + added);
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {31, 32, 33, 34})
  void howeverOftenTheHullIsSplitNoSiteLeavesIt(long seed) {
    Random random = new Random(seed);
    int inside = 0;
    for (int i = 0; i < 20; i++) {
      FakeContext context = new FakeContext(Domain.SITES, coordinates(random, 24, i % 3));
      for (int k = 0; k < 5; k++) {
        Points before = context.points();
        BitSet hull = hull(before);
        Triangulation triangulation = delaunay(before);
        int edge = boundaryEdge(triangulation, random);
        splitEdge(
            context,
            triangulation.from(edge),
            triangulation.to(edge),
            0.01 + 0.98 * random.nextDouble());
        if (context.points().equals(before)) {
          assertThat(context.said).isNotEmpty();
          continue;
        }
        BitSet after = hull(context.points());
        int added = before.size();
        inside += after.get(added) ? 0 : 1;
        after.clear(added);
        assertThat(after).as("seed %d, %d, %d", seed, i, k).isEqualTo(hull);
      }
    }
    assertThat(inside).as("seed %d: some have no place outside", seed).isPositive();
  }

  @ParameterizedTest
  @ValueSource(longs = {41, 42, 43, 44})
  void howeverOftenASideIsSplitThePolygonStaysSimple(long seed) {
    Random random = new Random(seed);
    for (int i = 0; i < 20; i++) {
      double[] pairs = coordinates(random, 6, i % 3);
      FakeContext context = new FakeContext(Domain.POLYGON, pairs);
      int side = random.nextInt(3);
      for (int k = 0; k < 5; k++) {
        int n = context.points().size();
        split(context, side, 0.01 + 0.98 * random.nextDouble());
        assertThat(context.points().size() > n || !context.said.isEmpty()).isTrue();
        assertThat(SimplicityCheck.firstDefect(context.points(), Progress.NONE))
            .as("seed %d, %d, %d", seed, i, k)
            .isEmpty();
      }
    }
  }

  /** Whole ones, tenths, or doubles with all their digits. */
  private static double[] coordinates(Random random, int count, int kind) {
    return random
        .doubles(count, 0, 1000)
        .map(c -> kind == 0 ? Math.rint(c) : kind == 1 ? Math.rint(10 * c) / 10 : c)
        .toArray();
  }

  /**
   * The sites on the boundary of the hull, in exact numbers: those in a line with all on one side.
   */
  private static BitSet hull(Points points) {
    BitSet hull = new BitSet();
    for (int v = 0; v < points.size(); v++) {
      for (int w = 0; w < points.size(); w++) {
        if (w != v && allOnOneSide(points, v, w)) {
          hull.set(v);
        }
      }
    }
    return hull;
  }

  private static boolean allOnOneSide(Points points, int v, int w) {
    int side = 0;
    for (int c = 0; c < points.size(); c++) {
      int turn = cross(points, v, w, points, c);
      if (turn * side < 0) {
        return false;
      }
      side = side == 0 ? turn : side;
    }
    return true;
  }

  private static Triangulation delaunay(Points sites) {
    return Delaunay.triangulate(Sites.of(sites, Progress.NONE), Progress.NONE);
  }

  private static int boundaryEdge(Triangulation triangulation, Random random) {
    int edge;
    do {
      edge = random.nextInt(triangulation.edgeCount());
    } while (triangulation.kind(edge) != EdgeKind.BOUNDARY);
    return edge;
  }

  private static FakeContext context(Domain domain, Points points) {
    double[] pairs = new double[2 * points.size()];
    for (int v = 0; v < points.size(); v++) {
      pairs[2 * v] = points.x(v);
      pairs[2 * v + 1] = points.y(v);
    }
    return new FakeContext(domain, pairs);
  }

  private static Points triangle(DoubleSupplier next) {
    Points points;
    do {
      double[] pairs = new double[6];
      java.util.Arrays.setAll(pairs, i -> next.getAsDouble());
      points = Points.ofPairs(pairs);
    } while (points.orient(0, 1, 2) == 0);
    return points;
  }

  private static void split(FakeContext context, int v, double t) {
    splitEdge(context, v, (v + 1) % context.points().size(), t);
  }

  private static void splitEdge(FakeContext context, int a, int b, double t) {
    Points points = context.points();
    double x = points.x(a) * (1 - t) + points.x(b) * t;
    double y = points.y(a) * (1 - t) + points.y(b) * t;
    context.said = "";
    SplitTool tool = new SplitTool();
    tool.pressed(context, context.spot(context.viewport.screenX(x), context.viewport.screenY(y)));
  }

  private static int cross(Points edges, int v, Points points, int c) {
    return cross(edges, v, (v + 1) % edges.size(), points, c);
  }

  private static int cross(Points edges, int v, int w, Points points, int c) {
    BigDecimal left = minus(edges.x(w), edges.x(v)).multiply(minus(points.y(c), edges.y(v)));
    BigDecimal right = minus(edges.y(w), edges.y(v)).multiply(minus(points.x(c), edges.x(v)));
    return left.compareTo(right);
  }

  private static BigDecimal minus(double a, double b) {
    return new BigDecimal(a).subtract(new BigDecimal(b));
  }
}
