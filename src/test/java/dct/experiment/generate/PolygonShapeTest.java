package dct.experiment.generate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.testing.SimplicityOracle;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.EnumSource.Mode;
import org.junit.jupiter.params.provider.ValueSource;

class PolygonShapeTest {
  private static final int SEEDS = 2000;

  @ParameterizedTest
  @EnumSource
  void every_polygon_on_a_small_grid_is_simple_or_is_refused(PolygonShape shape) {
    int made = 0;
    for (int seed = 0; seed < SEEDS; seed++) {
      int n = 3 + seed % 14;
      Area area = new Area(1 + seed / 14 % 8, 1 + seed / 112 % 7, seed % 5 != 0);
      try {
        check(shape.generate(n, area, seed, Progress.NONE), n, area, shape + ", seed " + seed);
        made++;
      } catch (CannotGenerateException e) {
        assertThat(e.getMessage()).contains("; ");
      }
    }
    assertThat(made).isGreaterThan(SEEDS / 10);
  }

  @ParameterizedTest
  @EnumSource
  void every_polygon_on_the_canvas_is_simple(PolygonShape shape) {
    for (int seed = 0; seed < 150; seed++) {
      int n = 4 + 2 * seed / 3 * 2; // even, for those that must be
      Area area = seed % 2 == 0 ? shape.areaFor(n) : Area.CANVAS.real();
      check(shape.generate(n, area, seed, Progress.NONE), n, area, shape + ", seed " + seed);
    }
  }

  private static void check(SimplePolygon polygon, int n, Area area, String what) {
    Points p = polygon.points();
    assertThat(p.size()).as(what).isEqualTo(n);
    assertThat(polygon.isClockwise()).as(what).isFalse();
    assertThat(SimplicityOracle.isSimple(p)).as(what).isTrue();
    boolean inside = true;
    for (int i = 0; i < n; i++) {
      inside &= isIn(p.x(i), area.width(), area) && isIn(p.y(i), area.height(), area);
    }
    assertThat(inside).as(what).isTrue();
  }

  private static boolean isIn(double value, int size, Area area) {
    return value >= 0 && value < size && (!area.whole() || value == Math.rint(value));
  }

  /** Where every place is taken, many of them lie on one line; there is a polygon all the same. */
  @ParameterizedTest
  @EnumSource(names = {"TWO_OPT", "TOUR", "STEADY_GROWTH", "SPACE_PARTITIONING", "X_MONOTONE"})
  void all_places_of_a_full_grid_are_used(PolygonShape shape) {
    for (int seed = 0; seed < 200; seed++) {
      Area area = new Area(2 + seed % 6, 2 + seed / 6 % 6, true);
      int n = area.width() * area.height();
      check(shape.generate(n, area, seed, Progress.NONE), n, area, shape + ", seed " + seed);
    }
  }

  /** Pinned: these very polygons are what a seed in a paper stands for. */
  @ParameterizedTest
  @CsvSource({
    "TWO_OPT, 1005422624, -871145670",
    "STEADY_GROWTH, 1013499936, -1464502146",
    "SPACE_PARTITIONING, -572037088, 1507338138",
    "STAR_SHAPED, 323577888, -1723031566",
    "X_MONOTONE, 1297242144, 1331434306",
    "CONVEX, -1565798368, 1128183618",
    "ORTHOGONAL, 864120864, -1925164256",
    "COMB, 756027424, 825357552",
    "SPIRAL, -537366496, 1225574528",
    "SPANNING_TREE, 259958816, -681695578",
    "TOUR, -1858676704, -1408040784"
  })
  void a_seed_stands_for_the_same_polygon_for_ever(PolygonShape shape, int whole, int real) {
    assertThat(shape.generate(100, 7).points().hashCode()).isEqualTo(whole);
    Area area = Area.CANVAS.real();
    assertThat(shape.generate(100, area, 7, Progress.NONE).points().hashCode()).isEqualTo(real);
    assertThat(shape.generate(100, 8).points()).isNotEqualTo(shape.generate(100, 7).points());
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 4, 5, 17, 60})
  void convex_polygons_turn_left_at_every_vertex(int n) {
    for (int seed = 0; seed < 100; seed++) {
      Points p = PolygonShape.CONVEX.generate(n, seed).points();
      for (int i = 0; i < n; i++) {
        assertThat(p.orient(i, (i + 1) % n, (i + 2) % n)).as("seed %d", seed).isEqualTo(1);
      }
    }
  }

  @Test
  void the_centre_of_a_star_shaped_polygon_sees_every_edge() {
    for (int seed = 0; seed < 1000; seed++) {
      int n = 3 + seed % 20;
      Area area = new Area(5 + seed % 7, 5, true);
      SeededRandom random = new SeededRandom(seed);
      StarShaped star = new StarShaped(Places.spread(n, area.grid(), random), random);
      Points p = PolygonShape.STAR_SHAPED.generate(n, area, seed, Progress.NONE).points();
      for (int i = 0; i < n; i++) {
        assertThat(isLeft(p, i, (i + 1) % n, star)).as("seed %d", seed).isTrue();
      }
    }
  }

  /** Whether three times the centre lies on the left of three times the edge, or on its line. */
  private static boolean isLeft(Points p, int a, int b, StarShaped star) {
    double dx = 3 * (p.x(b) - p.x(a));
    double dy = 3 * (p.y(b) - p.y(a));
    return dx * (star.centreY() - 3 * p.y(a)) - dy * (star.centreX() - 3 * p.x(a)) >= 0;
  }

  @Test
  void edges_of_orthogonal_polygons_are_level_and_upright_in_turn() {
    for (int seed = 0; seed < 300; seed++) {
      int n = 4 + 2 * (seed % 100);
      Points p = PolygonShape.ORTHOGONAL.generate(n, seed).points();
      boolean firstIsLevel = p.y(0) == p.y(1);
      for (int i = 0; i < n; i++) {
        int next = (i + 1) % n;
        boolean level = firstIsLevel == (i % 2 == 0);
        assertThat(p.y(i) == p.y(next)).as("seed %d", seed).isEqualTo(level);
        assertThat(p.x(i) == p.x(next)).as("seed %d", seed).isNotEqualTo(level);
      }
    }
  }

  @Test
  void monotone_polygons_change_their_direction_in_x_twice() {
    for (int seed = 0; seed < 300; seed++) {
      int n = 3 + seed % 50;
      Points p = PolygonShape.X_MONOTONE.generate(n, seed).points();
      int changes = 0;
      for (int i = 0; i < n; i++) {
        changes += goesRight(p, i, n) != goesRight(p, (i + 1) % n, n) ? 1 : 0;
      }
      assertThat(changes).as("seed %d", seed).isEqualTo(2);
    }
  }

  private static boolean goesRight(Points p, int i, int n) {
    double dx = p.x((i + 1) % n) - p.x(i);
    return dx > 0 || (dx == 0 && p.y((i + 1) % n) > p.y(i));
  }

  @ParameterizedTest
  @EnumSource(
      mode = Mode.EXCLUDE,
      names = {"TWO_OPT", "STEADY_GROWTH", "BENT_EDGES"})
  void large_polygons_are_simple(PolygonShape shape) {
    assertThat(shape.generate(20_000, 3).size()).isEqualTo(20_000);
  }

  @Test
  void bent_edges_give_any_share_of_reflex_vertices() {
    int[] polygons = new int[10]; // by the tenth of the share
    for (int seed = 0; seed < 200; seed++) {
      SimplePolygon polygon = PolygonShape.BENT_EDGES.generate(60, seed);
      int reflex = 0;
      for (int v = 0; v < 60; v++) {
        reflex += polygon.points().orient((v + 59) % 60, v, (v + 1) % 60) < 0 ? 1 : 0;
      }
      polygons[reflex / 6]++;
    }
    assertThat(polygons).as(java.util.Arrays.toString(polygons)).doesNotContain(0);
  }

  @Test
  void an_impossible_number_is_refused_with_a_reason() {
    assertRefused(PolygonShape.TWO_OPT, 2, Area.CANVAS, "from 3 to");
    assertRefused(PolygonShape.TWO_OPT, PolygonShape.MOST + 1, Area.CANVAS, "from 3 to");
    assertRefused(PolygonShape.TOUR, 10, new Area(3, 3, true), "do not fit into 9 places");
    assertRefused(PolygonShape.STAR_SHAPED, 4, new Area(9, 1, true), "on one line");
    assertRefused(PolygonShape.CONVEX, 60, new Area(9, 9, true), "no strictly convex polygon");
    assertRefused(PolygonShape.ORTHOGONAL, 7, Area.CANVAS, "even number");
    assertRefused(PolygonShape.ORTHOGONAL, 90, new Area(5, 5, true), "no orthogonal polygon");
    assertRefused(PolygonShape.BENT_EDGES, 9, Area.CANVAS, "need real coordinates");
    assertRefused(PolygonShape.COMB, 60, new Area(9, 9, true), "a comb of 60 vertices needs 58");
    assertRefused(PolygonShape.SPIRAL, 60, new Area(9, 9, true), "needs 31 places a side");
    assertRefused(PolygonShape.SPANNING_TREE, 90, new Area(9, 9, true), "23 cells");
  }

  private static void assertRefused(PolygonShape shape, int n, Area area, String reason) {
    assertThatThrownBy(() -> shape.generate(n, area, 1, Progress.NONE))
        .isInstanceOf(CannotGenerateException.class)
        .hasMessageContaining(reason);
  }

  @ParameterizedTest
  @EnumSource
  void a_word_names_one_shape(PolygonShape shape) {
    assertThat(PolygonShape.of(shape.word())).contains(shape);
    assertThat(PolygonShape.words()).contains(shape.word());
    assertThat(PolygonShape.of(shape.title())).isEmpty();
  }

  @ParameterizedTest
  @EnumSource(names = {"TWO_OPT", "TOUR", "STEADY_GROWTH", "CONVEX", "ORTHOGONAL", "SPANNING_TREE"})
  void a_cancelled_polygon_is_not_made(PolygonShape shape) {
    Progress cancelled =
        new Progress() {
          @Override
          public void report(double fraction, String message) {}

          @Override
          public boolean isCancelled() {
            return true;
          }
        };
    assertThatThrownBy(() -> shape.generate(10, Area.CANVAS, 1, cancelled))
        .isInstanceOf(CancellationException.class);
  }
}
