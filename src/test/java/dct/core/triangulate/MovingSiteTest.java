package dct.core.triangulate;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.testing.EdgeGraph;
import dct.testing.RandomSets;
import dct.testing.RandomSets.Family;
import dct.testing.TriangulationAssert;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * A site is dragged; after each move the triangulation is compared with one made anew.
 *
 * <pre>
 * MovingSite moving = MovingSite.of(delaunay, 4).orElseThrow();
 * MovedSite moved = moving.to(2, 3);
 * moved.removed(); // edges of delaunay that there are no longer
 * moved.added(); // and those that there were not
 * </pre>
 */
class MovingSiteTest {
  private static final int MOVES = 12;

  static List<Family> families() {
    return RandomSets.families();
  }

  @ParameterizedTest
  @MethodSource("families")
  void everyMoveMakesADelaunayTriangulation(Family family) {
    for (int seed = 0; seed < (isSlow(family) ? 2 : 36); seed++) {
      drag(family, 4 + seed % 28, seed);
    }
  }

  /** As many moves as are asked for: {@code -Ddct.moves=200}, one seed after the other. */
  @ParameterizedTest
  @MethodSource("families")
  void aLongCampaign(Family family) {
    int seeds = Integer.getInteger("dct.moves", 1);
    for (int seed = 0; seed < seeds; seed++) {
      drag(family, 4 + seed % 120, 1_000_000L + seed);
    }
  }

  /** Numbers that only the slowest exact stage can compare. */
  private static boolean isSlow(Family family) {
    return family.name().equals("least and largest numbers")
        || family.name().equals("wide range of exponents");
  }

  private static void drag(Family family, int n, long seed) {
    Sites sites = family.make(n, seed);
    Triangulation start = Delaunay.triangulate(sites, Progress.NONE);
    Random random = new Random(seed);
    for (int drag = 0; drag < 3 && sites.size() > 0; drag++) {
      int site = random.nextInt(sites.size());
      Optional<MovingSite> moving = MovingSite.of(start, site);
      assertThat(moving.isEmpty())
          .as("%s, n = %d, seed %d: all but v%d on one line", family, n, seed, site)
          .isEqualTo(isFlatWithout(sites.points(), site));
      for (int move = 0; move < MOVES && moving.isPresent(); move++) {
        double[] place = place(sites.points(), site, random);
        if (Double.isFinite(place[0]) && Double.isFinite(place[1])) {
          check(
              moving.get(),
              place[0] + 0.0,
              place[1] + 0.0,
              "%s, n = %d, seed %d: v%d to (%s, %s)"
                  .formatted(family, n, seed, site, place[0], place[1]));
        }
      }
    }
  }

  private static boolean isFlatWithout(Points points, int site) {
    return points.size() < 4 || Sites.of(points.removed(site), Progress.NONE).areOnOneLine();
  }

  /** Somewhere: near, far, on a site, on or beyond the line through two, on a circle of three. */
  private static double[] place(Points p, int site, Random random) {
    int a = random.nextInt(p.size());
    int b = random.nextInt(p.size());
    double dx = p.x(b) / 2 - p.x(a) / 2;
    double dy = p.y(b) / 2 - p.y(a) / 2;
    return switch (random.nextInt(9)) {
      case 0 -> new double[] {p.x(a), p.y(a)};
      case 1 -> new double[] {p.x(a) + dx, p.y(a) + dy};
      case 2 -> new double[] {p.x(b) + dx, p.y(b) + dy};
      case 3 -> new double[] {p.x(a) - 4 * dx, p.y(a) - 4 * dy};
      case 4 -> new double[] {p.x(b) + 1e3 * dy, p.y(b) - 1e3 * dx};
      case 5 -> new double[] {p.x(a), p.y(b)};
      case 6 -> new double[] {p.x(site), p.y(site)};
      case 7 -> new double[] {Math.nextUp(p.x(a)), p.y(a)};
      default ->
          new double[] {p.x(a) + dx * random.nextDouble(), p.y(b) - dy * random.nextDouble()};
    };
  }

  private static void check(MovingSite moving, double x, double y, String what) {
    Triangulation start = moving.start();
    MovedSite moved = moving.to(x, y);
    Points points = start.points().moved(moving.site(), x, y);
    assertThat(moved.merged()).as(what).isEqualTo(isTaken(points, moving.site()));
    int gone = moved.merged() ? moving.site() : points.size();
    Points others = moved.merged() ? points.removed(gone) : points;
    Sites sites = Sites.of(others, Progress.NONE);
    EdgeGraph graph = new EdgeGraph(others);
    Set<String> edges = edges(start, moved);
    for (String edge : edges) {
      int[] ends = Arrays.stream(edge.split(" ")).limit(2).mapToInt(Integer::parseInt).toArray();
      graph.add(ends[0] > gone ? ends[0] - 1 : ends[0], ends[1] > gone ? ends[1] - 1 : ends[1]);
    }
    Triangulation now = graph.triangulation();
    TriangulationAssert.assertThat(now).as(what).isTriangulationOf(sites).isDelaunay();
    checkDegrees(start, moved, now, what);
    Triangulation anew = Delaunay.triangulate(sites, Progress.NONE);
    if (isUnique(anew)) {
      assertThat(edges).as(what).isEqualTo(edges(anew, gone));
    }
    assertThat(boundary(edges)).as(what).isEqualTo(boundary(edges(anew, gone)));
  }

  private static boolean isTaken(Points points, int site) {
    return IntStream.range(0, points.size()).anyMatch(v -> v != site && points.same(v, site));
  }

  /**
   * The degrees that the move names are right, and those that it does not name have not changed.
   */
  private static void checkDegrees(
      Triangulation start, MovedSite moved, Triangulation now, String what) {
    int[] degrees = IntStream.range(0, start.vertexCount()).map(start::degree).toArray();
    for (int k = 0; k < moved.changed().size(); k++) {
      int v = moved.changed().get(k);
      assertThat(degrees[v]).as(what + ": v" + v).isNotEqualTo(moved.degrees().get(k));
      degrees[v] = moved.degrees().get(k);
    }
    boolean still = moved.removed().isEmpty() && moved.added().isEmpty();
    degrees[moved.site()] = still ? degrees[moved.site()] : moved.degree();
    int[] expected =
        IntStream.range(0, degrees.length)
            .map(
                v ->
                    !moved.merged() || v < moved.site()
                        ? now.degree(v)
                        : v == moved.site() ? 0 : now.degree(v - 1))
            .toArray();
    assertThat(degrees).as(what).isEqualTo(expected);
  }

  private static Set<String> edges(Triangulation start, MovedSite moved) {
    Set<String> edges = new HashSet<>();
    for (int edge = 0; edge < start.edgeCount(); edge++) {
      edges.add(edge(start.from(edge), start.to(edge), start.kind(edge)));
    }
    for (MovedSite.Edge edge : moved.removed()) {
      assertThat(edges.remove(edge(edge.from(), edge.to(), edge.kind()))).isTrue();
    }
    for (MovedSite.Edge edge : moved.added()) {
      assertThat(edges.add(edge(edge.from(), edge.to(), edge.kind()))).isTrue();
    }
    return edges;
  }

  /** The edges with the numbers that the sites had before one of them was left out. */
  private static Set<String> edges(Triangulation t, int gone) {
    Set<String> edges = new HashSet<>();
    for (int edge = 0; edge < t.edgeCount(); edge++) {
      int from = t.from(edge);
      int to = t.to(edge);
      edges.add(edge(from < gone ? from : from + 1, to < gone ? to : to + 1, t.kind(edge)));
    }
    return edges;
  }

  private static String edge(int from, int to, EdgeKind kind) {
    return Math.min(from, to) + " " + Math.max(from, to) + " " + kind;
  }

  private static Set<String> boundary(Set<String> edges) {
    Set<String> boundary = new HashSet<>(edges);
    boundary.removeIf(edge -> !edge.endsWith(EdgeKind.BOUNDARY.name()));
    return boundary;
  }

  /** Whether there is no other Delaunay triangulation of these sites. */
  private static boolean isUnique(Triangulation t) {
    return IntStream.range(0, t.edgeCount())
        .filter(edge -> t.kind(edge) == EdgeKind.DIAGONAL)
        .noneMatch(
            edge -> {
              int e = 2 * edge;
              int c = t.dcel().origin(t.dcel().prev(e));
              int d = t.dcel().origin(t.dcel().prev(e ^ 1));
              return t.points().inCircle(t.from(edge), t.to(edge), c, d) == 0;
            });
  }

  @Test
  void theExample() {
    Points points = Points.ofPairs(0, 0, 4, 0, 4, 4, 0, 4, 2, 1);
    Triangulation delaunay = Delaunay.triangulate(Sites.of(points, Progress.NONE), Progress.NONE);
    MovingSite moving = MovingSite.of(delaunay, 4).orElseThrow();
    assertThat(moving.to(2, 3).degree()).isEqualTo(4);
    assertThat(moving.to(6, 2).degree()).as("outside, where it sees one side").isEqualTo(2);
    assertThat(moving.to(4, 2).degree()).as("on that side").isEqualTo(4);
    assertThat(moving.to(4, 4).merged()).isTrue();
    assertThat(moving.to(2, 1).removed()).as("back").isEmpty();
  }

  @Test
  void whereItComesFromMakesNoDifference() {
    Random random = new Random(3);
    Sites sites = RandomSets.families().get(2).make(80, 3);
    Triangulation start = Delaunay.triangulate(sites, Progress.NONE);
    MovingSite wandering = MovingSite.of(start, 7).orElseThrow();
    for (int move = 0; move < 200; move++) {
      double x = random.nextInt(12) / 2.0;
      double y = random.nextInt(12) / 2.0;
      assertThat(wandering.to(x, y)).isEqualTo(MovingSite.of(start, 7).orElseThrow().to(x, y));
    }
  }

  @Test
  void aSiteWithVeryManyEdgesStays() {
    int n = MovingSite.MOST_EDGES + 1;
    double[] x = new double[n + 1];
    double[] y = new double[n + 1];
    for (int v = 0; v < n; v++) {
      x[v] = Math.cos(2 * Math.PI * v / n);
      y[v] = Math.sin(2 * Math.PI * v / n);
    }
    Triangulation star =
        Delaunay.triangulate(Sites.of(Points.of(x, y), Progress.NONE), Progress.NONE);
    assertThat(MovingSite.of(star, n)).isEmpty();
    assertThat(MovingSite.of(star, 0)).isPresent();
  }
}
