package dct.core.degree.best;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.degree.best.BoundCheck.Verdict;
import dct.core.degree.bound.SmallSets;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.testing.FlipGraph;
import dct.testing.RandomPolygons;
import dct.testing.RandomSets.Family;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Claims about small inputs: those up to the optimum are proven again, the others refuted. */
class BoundCheckTest {

  private static List<Family> sets() {
    return SmallSets.families();
  }

  private static List<RandomPolygons.Family> polygons() {
    return RandomPolygons.families();
  }

  private static Verdict expected(int claimed, int least) {
    return claimed <= least ? Verdict.RECOMPUTED : Verdict.FALSE;
  }

  @ParameterizedTest
  @MethodSource("sets")
  void claimsAboutFewSitesAreDecided(Family family) {
    for (long seed = 0; seed < 6; seed++) {
      Sites sites = family.make(8, seed);
      ParityGoal goal = ParityGoal.allEven(sites.size());
      if (sites.size() > 2 && sites.size() < 11) {
        int least = new FlipGraph(sites.points()).least(goal);
        for (int claimed = 0; claimed < least + 4; claimed++) {
          BoundCheck check = BoundCheck.of(sites, goal, claimed, Progress.NONE);
          assertThat(check.recomputed().value()).isLessThanOrEqualTo(least);
          assertThat(check.verdict())
              .as("%s, seed %d: %d of %d", family, seed, claimed, least)
              .isEqualTo(expected(claimed, least));
        }
      }
    }
  }

  @ParameterizedTest
  @MethodSource("polygons")
  void claimsAboutPolygonsAreDecided(RandomPolygons.Family family) {
    for (int seed = 0; seed < 4; seed++) {
      SimplePolygon polygon = SimplePolygon.of(family.make(30, seed), Progress.NONE);
      ParityGoal goal = ParityGoal.allEven(polygon.size());
      Optimum best = PolygonOptimizer.optimize(polygon, goal, SearchLimits.DEFAULT, Progress.NONE);
      for (int claimed : new int[] {best.unsatisfied(), best.unsatisfied() + 2}) {
        assertThat(BoundCheck.of(polygon, goal, claimed, Progress.NONE).verdict())
            .as("%s, seed %d: %d of %d", family, seed, claimed, best.unsatisfied())
            .isEqualTo(expected(claimed, best.unsatisfied()));
      }
    }
  }
}
