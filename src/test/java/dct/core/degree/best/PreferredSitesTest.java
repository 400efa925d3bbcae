package dct.core.degree.best;

import static dct.testing.TriangulationAssert.assertThat;
import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.Preference;
import dct.core.degree.Preferred;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.SiteShape;
import dct.testing.CancelledAfter;
import dct.testing.RandomPolygons;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Where no table applies, what was found is made more preferred, region by region. */
class PreferredSitesTest {

  private static List<Preference> preferences(Triangulation given) {
    return List.of(Preference.ANGLE, Preference.LENGTH, Preference.keeping(given));
  }

  private static ParityGoal mixed(int n, Random random) {
    Wish[] wishes = new Wish[n];
    for (int v = 0; v < n; v++) {
      wishes[v] = List.of(Wish.values()).get(random.nextInt(3));
    }
    return ParityGoal.of(wishes);
  }

  @Test
  void sites_lose_nothing_and_gain_by_every_preference() {
    int gains = 0;
    int all = 0;
    for (SiteShape shape : SiteShape.values()) {
      Sites sites = Sites.of(shape.generate(70, 5), Progress.NONE);
      Triangulation start = Delaunay.triangulate(sites, Progress.NONE);
      int n = sites.size();
      for (ParityGoal goal : List.of(ParityGoal.allEven(n), mixed(n, new Random(3)))) {
        Optimum plain = BestTriangulation.of(start, goal, SearchLimits.DEFAULT, Progress.NONE);
        for (Preference preference : preferences(start)) {
          Preferred found = prefer(start, goal, preference);
          assertThat(found.optimum().triangulation()).isTriangulationOf(sites);
          assertThat(found.optimum().unmet())
              .isEqualTo(goal.unmet(found.optimum().triangulation()))
              .isLessThanOrEqualTo(plain.unmet());
          assertThat(found.value()).isEqualTo(preference.value(found.optimum().triangulation()));
          double before = preference.value(plain.triangulation());
          assertThat(preference.isBetter(before, found.value()))
              .as("%s, %s: %s is no worse than %s", shape, preference, found.value(), before)
              .isFalse();
          gains += preference.isBetter(found.value(), before) ? 1 : 0;
          all++;
          assertThat(prefer(start, goal, preference).value()).isEqualTo(found.value());
        }
      }
    }
    assertThat(gains).isGreaterThan(all * 3 / 4);
  }

  private static Preferred prefer(Triangulation start, ParityGoal goal, Preference preference) {
    return BestTriangulation.of(start, goal, SearchLimits.DEFAULT, preference, Progress.NONE);
  }

  /** A convex polygon of which all can be even, too large for a table that is not needed. */
  @Test
  void a_large_polygon_is_made_more_preferred_too() {
    SimplePolygon polygon =
        SimplePolygon.of(RandomPolygons.convex(1500, new Random(2)), Progress.NONE);
    Triangulation start = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    ParityGoal goal = ParityGoal.allEven(polygon.size());
    Optimum plain = BestTriangulation.of(polygon, start, goal, SearchLimits.DEFAULT, Progress.NONE);
    Preferred found =
        BestTriangulation.of(
            polygon, start, goal, SearchLimits.DEFAULT, Preference.LENGTH, Progress.NONE);
    assertThat(found.optimum().triangulation()).isTriangulationOf(polygon);
    assertThat(found.optimum().unmet()).isEqualTo(plain.unmet());
    assertThat(found.isProven()).isFalse();
    assertThat(found.value()).isLessThan(0.9 * Preference.LENGTH.value(plain.triangulation()));
  }

  @Test
  void a_cancel_at_any_question_gives_the_best_so_far() {
    Points points = SiteShape.UNIFORM.generate(300, 4);
    Triangulation start = Delaunay.triangulate(Sites.of(points, Progress.NONE), Progress.NONE);
    ParityGoal goal = ParityGoal.allEven(points.size());
    for (int questions = 0; questions < 3000; questions += 1 + questions / 3) {
      CancelledAfter cancel = new CancelledAfter(questions);
      Preferred found =
          BestTriangulation.of(start, goal, SearchLimits.DEFAULT, Preference.ANGLE, cancel);
      assertThat(found.optimum().unmet())
          .isEqualTo(goal.unmet(found.optimum().triangulation()))
          .isLessThanOrEqualTo(goal.unmet(start));
    }
  }
}
