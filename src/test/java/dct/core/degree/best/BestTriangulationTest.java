package dct.core.degree.best;

import static dct.testing.TriangulationAssert.assertThat;
import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.DegreeCount;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.RandomSites;
import dct.testing.RandomPolygons;
import java.lang.System.Logger.Level;
import java.util.Random;
import org.junit.jupiter.api.Test;

class BestTriangulationTest {
  private static final System.Logger LOG = System.getLogger("dct.table");

  /** The setting of Table 4.4: ten sizes, five sets. */
  @Test
  void attainsTheBoundOnAllFiftySetsOfTable44() {
    StringBuilder table = new StringBuilder("\n set    n  before  scan-flip  best  bound\n");
    for (int set = 1; set <= 5; set++) {
      for (int n = 50; n <= 500; n += 50) {
        Sites sites = Sites.of(RandomSites.uniform(n, 1000L * set + n), Progress.NONE);
        Triangulation delaunay = Delaunay.triangulate(sites, Progress.NONE);
        ParityGoal goal = ParityGoal.allEven(n);

        Optimum best = BestTriangulation.of(delaunay, goal, SearchLimits.DEFAULT, Progress.NONE);

        assertThat(best.triangulation()).isTriangulationOf(sites);
        assertThat(best.unmet())
            .as("set %d, %d sites: %s", set, n, best.bound())
            .isEqualTo(goal.unmet(best.triangulation()))
            .isEqualTo(best.bound().value());
        table.append(
            "%4d %4d %7d %10d %5d %6d%n"
                .formatted(
                    set,
                    n,
                    DegreeCount.of(delaunay).odd(),
                    DegreeCount.of(ScanFlip.run(delaunay, Progress.NONE).after()).odd(),
                    best.unmet(),
                    best.bound().value()));
      }
    }
    LOG.log(Level.INFO, table.toString());
  }

  @Test
  void fewSitesAreSolvedExactly() {
    for (int seed = 0; seed < 20; seed++) {
      Sites sites = Sites.of(RandomSites.uniform(5 + seed % 8, seed), Progress.NONE);
      ParityGoal goal = ParityGoal.allEven(sites.size());

      Optimum best = BestTriangulation.of(sites, goal, SearchLimits.DEFAULT, Progress.NONE);

      assertThat(best.triangulation()).isTriangulationOf(sites);
      assertThat(best.isProven()).as("seed %d: %s", seed, best.bound()).isTrue();
    }
  }

  @Test
  void polygonsGoToTheExactTable() {
    SimplePolygon polygon =
        SimplePolygon.of(RandomPolygons.starShaped(80, new Random(1)), Progress.NONE);
    ParityGoal goal = ParityGoal.allOdd(polygon.size());

    Optimum best = BestTriangulation.of(polygon, goal, SearchLimits.DEFAULT, Progress.NONE);

    assertThat(best.triangulation()).isTriangulationOf(polygon);
    assertThat(best.isProven()).isTrue();
  }
}
