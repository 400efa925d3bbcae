package dct.core.degree.exact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.degree.DegreeCount;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.testing.TriangulationAssert;
import java.util.Random;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;

class ExactSitesTest {

  private static Triangulation random(int n, long seed) {
    double[] pairs = new Random(seed).doubles(2L * n).toArray();
    return Delaunay.triangulate(Sites.of(Points.ofPairs(pairs), Progress.NONE), Progress.NONE);
  }

  @Test
  void sixteenSitesAreSolvedAndSaidToBe() {
    Triangulation start = random(16, 5);
    Optimum optimum = ExactSites.optimize(start, ParityGoal.allEven(16), Progress.NONE);
    TriangulationAssert.assertThat(optimum.triangulation())
        .isTriangulationOf(Sites.of(start.points(), Progress.NONE));
    assertThat(optimum.isProven()).isTrue();
    assertThat(optimum.interrupted()).isFalse();
    assertThat(optimum.bound().reason()).isEqualTo("every triangulation of 16 sites searched");
    assertThat(optimum.unmet()).isEqualTo(DegreeCount.of(optimum.triangulation()).odd());
  }

  @Test
  void theVerticesKeepTheirNumbers() {
    Triangulation start = random(9, 8);
    Optimum optimum = ExactSites.optimize(start, ParityGoal.allOdd(9), Progress.NONE);
    assertThat(optimum.triangulation().points()).isEqualTo(start.points());
  }

  @Test
  void randomSitesBeyondSixteenAreRefusedButALatticeOfTwentyIsNot() {
    Triangulation many = random(19, 1);
    assertThat(ExactSites.canSolve(many)).isFalse();
    assertThatThrownBy(() -> ExactSites.optimize(many, ParityGoal.allEven(19), Progress.NONE))
        .isInstanceOf(IllegalArgumentException.class);
    double[] pairs = new double[40];
    for (int i = 0; i < 20; i++) {
      pairs[2 * i] = i % 5;
      pairs[2 * i + 1] = Math.floorDiv(i, 5);
    }
    Triangulation lattice =
        Delaunay.triangulate(Sites.of(Points.ofPairs(pairs), Progress.NONE), Progress.NONE);
    assertThat(ExactSites.canSolve(lattice)).isTrue();
    assertThat(ExactSites.optimize(lattice, ParityGoal.allEven(20), Progress.NONE).unmet())
        .isEqualTo(2);
  }

  @Test
  void sitesOnOneLineKeepTheirPath() {
    Triangulation path =
        Delaunay.triangulate(
            Sites.of(Points.ofPairs(0, 0, 1, 1, 2, 2), Progress.NONE), Progress.NONE);
    Optimum optimum = ExactSites.optimize(path, ParityGoal.allEven(3), Progress.NONE);
    assertThat(optimum.triangulation()).isSameAs(path);
    assertThat(optimum.unmet()).isEqualTo(2);
  }

  @Test
  void aCancelledSearchStops() {
    Progress cancelled =
        new Progress() {
          @Override
          public void report(double fraction, String message) {}

          @Override
          public boolean isCancelled() {
            return true;
          }
        };
    Triangulation start = random(12, 2);
    assertThatThrownBy(() -> ExactSites.optimize(start, ParityGoal.allEven(12), cancelled))
        .isInstanceOf(CancellationException.class);
  }
}
