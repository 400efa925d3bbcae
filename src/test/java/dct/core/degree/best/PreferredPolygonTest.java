package dct.core.degree.best;

import static dct.testing.TriangulationAssert.assertThat;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.Preference;
import dct.core.degree.Preferred;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.testing.EveryTriangulation;
import dct.testing.RandomPolygons;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Of polygons, the most preferred of the best triangulations. */
class PreferredPolygonTest {
  private static final int SEEDS = Integer.getInteger("dct.prefer.seeds", 12);

  private static Preferred optimize(
      SimplePolygon polygon, ParityGoal goal, Preference preference, SearchLimits limits) {
    Triangulation start = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    Preferred found = BestTriangulation.of(polygon, start, goal, limits, preference, Progress.NONE);
    Triangulation triangulation = found.optimum().triangulation();
    assertThat(triangulation).isTriangulationOf(polygon);
    assertThat(found.optimum().unmet()).isEqualTo(goal.unmet(triangulation));
    assertThat(found.value()).isEqualTo(preference.value(triangulation));
    return found;
  }

  /** Each kind of preference with each kind of wishes. */
  @Test
  void equals_enumeration() {
    int polygons = 0;
    for (RandomPolygons.Family family : RandomPolygons.families()) {
      for (int seed = 0; seed < SEEDS; seed++) {
        Random random = new Random(seed);
        Points points = family.maker().make(4 + random.nextInt(7), random);
        if (points.size() > 3 && points.size() <= 11) {
          polygons++;
          SimplePolygon polygon = SimplePolygon.of(points, Progress.NONE);
          for (ParityGoal goal : goals(points.size(), random)) {
            for (Preference preference : comparable(family, polygon)) {
              Preferred found = optimize(polygon, goal, preference, SearchLimits.DEFAULT);
              Enumerated best = enumerate(polygon, goal, preference);
              String what = family + ", seed " + seed + ", " + preference;
              assertThat(found.optimum().unmet()).as(what).isEqualTo(best.unmet);
              assertThat(found.value())
                  .as(what)
                  .isCloseTo(best.value, within(1e-9 + Preference.TOLERANCE * best.value));
              assertThat(found.isProven()).as(what).isTrue();
            }
          }
        }
      }
    }
    assertThat(polygons).isGreaterThan(10 * SEEDS);
  }

  private static List<ParityGoal> goals(int n, Random random) {
    Wish[] mixed = new Wish[n];
    Wish[] some = new Wish[n];
    for (int v = 0; v < n; v++) {
      mixed[v] = List.of(Wish.EVEN, Wish.ODD).get(random.nextInt(2));
      some[v] = List.of(Wish.values()).get(random.nextInt(3));
    }
    return List.of(
        ParityGoal.allEven(n), ParityGoal.allOdd(n), ParityGoal.of(mixed), ParityGoal.of(some));
  }

  private static List<Preference> preferences(SimplePolygon polygon) {
    Triangulation given = EarClipping.triangulate(polygon, Progress.NONE);
    return List.of(Preference.ANGLE, Preference.LENGTH, Preference.keeping(given));
  }

  /** Without the angle where the usual formula would overflow. */
  private static List<Preference> comparable(RandomPolygons.Family family, SimplePolygon polygon) {
    boolean overflows = family.name().equals("wide range of exponents");
    return preferences(polygon).subList(overflows ? 1 : 0, 3);
  }

  /** The best of all triangulations, its value computed another way. */
  private static final class Enumerated {
    private int unmet = Integer.MAX_VALUE;
    private double value;
  }

  private static Enumerated enumerate(
      SimplePolygon polygon, ParityGoal goal, Preference preference) {
    Enumerated best = new Enumerated();
    EveryTriangulation.of(
        polygon,
        (degrees, triangles) -> {
          int unmet = 0;
          for (int k = 0; k < degrees.length; k++) {
            unmet += goal.wish(polygon.vertex(k)).penalty(degrees[k]);
          }
          double value = value(polygon, triangles, preference);
          if (unmet < best.unmet
              || (unmet == best.unmet && preference.isBetter(value, best.value))) {
            best.unmet = unmet;
            best.value = value;
          }
        });
    return best;
  }

  /** Each edge is a side of one triangle on its upper side, but the last edge of the polygon. */
  private static double value(SimplePolygon polygon, int[] triangles, Preference preference) {
    int last = polygon.size() - 1;
    double sum = edge(polygon, 0, last, preference);
    double angle = 180;
    for (int t = 0; t < triangles.length; t += 3) {
      int i = triangles[t];
      int k = triangles[t + 1];
      int j = triangles[t + 2];
      sum += edge(polygon, i, k, preference) + edge(polygon, k, j, preference);
      angle = Math.min(angle, angle(polygon, i, k, j));
      angle = Math.min(angle, angle(polygon, k, j, i));
      angle = Math.min(angle, angle(polygon, j, i, k));
    }
    return preference.kind() == Preference.Kind.ANGLE ? angle : sum;
  }

  private static double edge(SimplePolygon polygon, int i, int j, Preference preference) {
    int u = polygon.vertex(i);
    int v = polygon.vertex(j);
    if (preference.kind() == Preference.Kind.KEPT) {
      return preference.isGiven(u, v) ? 1 : 0;
    }
    Points points = polygon.points();
    return Math.hypot(points.x(u) - points.x(v), points.y(u) - points.y(v));
  }

  /** At k. */
  private static double angle(SimplePolygon polygon, int i, int k, int j) {
    Points points = polygon.points();
    double ax = points.x(polygon.vertex(i)) - points.x(polygon.vertex(k));
    double ay = points.y(polygon.vertex(i)) - points.y(polygon.vertex(k));
    double bx = points.x(polygon.vertex(j)) - points.x(polygon.vertex(k));
    double by = points.y(polygon.vertex(j)) - points.y(polygon.vertex(k));
    return Math.toDegrees(Math.atan2(Math.abs(ax * by - ay * bx), ax * bx + ay * by));
  }

  /** No fewer wishes granted, on polygons that the table of one cost solves and on convex ones. */
  @Test
  void grants_as_many_wishes_as_without_a_preference() {
    for (RandomPolygons.Family family : RandomPolygons.families()) {
      SimplePolygon polygon =
          SimplePolygon.of(family.maker().make(120, new Random(3)), Progress.NONE);
      for (ParityGoal goal : goals(polygon.size(), new Random(5))) {
        int fewest =
            BestTriangulation.of(polygon, goal, SearchLimits.DEFAULT, Progress.NONE).unmet();
        for (Preference preference : preferences(polygon)) {
          Preferred found = optimize(polygon, goal, preference, SearchLimits.DEFAULT);
          Preferred timed = optimize(polygon, goal, preference, new SearchLimits(1, 1, 1000));
          assertThat(found.optimum().unmet()).as("%s", family).isEqualTo(fewest);
          assertThat(timed.optimum().unmet()).as("%s", family).isEqualTo(fewest);
          assertThat(timed.value()).as("%s", family).isEqualTo(found.value());
        }
      }
    }
  }
}
