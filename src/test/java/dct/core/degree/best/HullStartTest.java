package dct.core.degree.best;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.bound.SiteBounds;
import dct.core.degree.bound.SmallSets;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.testing.RandomSets.Family;
import dct.testing.TriangulationAssert;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class HullStartTest {

  private static List<Family> families() {
    return SmallSets.families();
  }

  @ParameterizedTest
  @MethodSource("families")
  void isATriangulationWithTheFirstEdgesOfTheWalk(Family family) {
    for (long seed = 0; seed < 8; seed++) {
      Sites sites = family.make(6 + 6 * (int) seed, seed);
      Triangulation start = Delaunay.triangulate(sites, Progress.NONE);
      if (start.triangleCount() > 0) {
        ParityGoal goal = ParityGoal.allEven(sites.size());
        Triangulation made = HullStart.of(start, goal, Progress.NONE);
        TriangulationAssert.assertThat(made).isTriangulationOf(sites);
        int[] edges = SiteBounds.walkedEdges(start, goal, Progress.NONE);
        for (int i = 0; i < 6; i += 2) {
          assertThat(made.edgeBetween(edges[i], edges[i + 1])).as("%s, %d", family, i).isPresent();
        }
      }
    }
  }
}
