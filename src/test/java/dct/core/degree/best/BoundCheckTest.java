package dct.core.degree.best;

import static dct.core.Progress.NONE;
import static org.assertj.core.api.Assertions.assertThat;

import dct.core.degree.LocalBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.best.BoundCheck.Verdict;
import dct.core.degree.bound.SiteBounds;
import dct.core.degree.bound.SmallSets;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.RandomSites;
import dct.testing.FlipGraph;
import dct.testing.RandomPolygons;
import dct.testing.RandomSets.Family;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
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
          BoundCheck check = BoundCheck.of(sites, goal, claimed, List.of(), NONE);
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
      SimplePolygon polygon = SimplePolygon.of(family.make(30, seed), NONE);
      ParityGoal goal = ParityGoal.allEven(polygon.size());
      Optimum best = BestTriangulation.of(polygon, goal, SearchLimits.DEFAULT, NONE);
      for (int claimed : new int[] {best.unmet(), best.unmet() + 2}) {
        assertThat(BoundCheck.of(polygon, goal, claimed, NONE).verdict())
            .as("%s, seed %d: %d of %d", family, seed, claimed, best.unmet())
            .isEqualTo(expected(claimed, best.unmet()));
      }
    }
  }

  /** A result of Scan-Flip whose author calls it optimal. */
  @Test
  void aSearchThatDoesBetterRefutesAnInventedBound() {
    Sites sites = Sites.of(RandomSites.uniform(50, 3), NONE);
    ParityGoal goal = ParityGoal.allEven(50);
    int invented = goal.unmet(ScanFlip.run(Delaunay.triangulate(sites, NONE), NONE).after());
    BoundCheck check = BoundCheck.of(sites, goal, invented, List.of(), NONE);
    assertThat(check.verdict()).isEqualTo(Verdict.FALSE);
    assertThat(check.recomputed().value()).isLessThan(invented);
  }

  @Test
  void aLargePolygonIsDecidedToo() {
    SimplePolygon polygon = SimplePolygon.of(RandomPolygons.starShaped(1600, new Random(5)), NONE);
    ParityGoal goal = ParityGoal.allEven(1600);
    int least = BestTriangulation.of(polygon, goal, SearchLimits.DEFAULT, NONE).unmet();
    assertThat(BoundCheck.of(polygon, goal, least, NONE).verdict()).isEqualTo(Verdict.RECOMPUTED);
    assertThat(BoundCheck.of(polygon, goal, least + 2, NONE).verdict()).isEqualTo(Verdict.FALSE);
  }

  /** 270 sites on the sides of a triangle and five in it: too many triangles to refute sets. */
  @Test
  void whatIsNeitherProvenNorRefutedIsOpen() {
    double[] pairs = SmallSets.sidesOfTriangle(90);
    Sites sites = Sites.of(Points.ofPairs(pairs), NONE);
    BoundCheck check = BoundCheck.of(sites, ParityGoal.allEven(275), 4, List.of(), NONE);
    assertThat(check.verdict()).isEqualTo(Verdict.OPEN);
    assertThat(check.recomputed().value()).isLessThan(4);
  }

  @Test
  void whatOnlyARefutationOfSetsProvesIsRecomputed() {
    double[] pairs = SmallSets.sidesOfTriangle(10);
    Sites sites = Sites.of(Points.ofPairs(pairs), NONE);
    BoundCheck check = BoundCheck.of(sites, ParityGoal.allEven(35), 4, List.of(), NONE);
    assertThat(check.verdict()).isEqualTo(Verdict.RECOMPUTED);
    assertThat(check.recomputed().reason())
        .isEqualTo("refuted: 596 sets of at most 2 odd vertices");
  }

  @Test
  void windowsAreCheckedBeforeAnythingElse() {
    double[] pairs = SmallSets.cross(10, 10);
    Sites sites = Sites.of(Points.ofPairs(pairs), NONE);
    ParityGoal goal = ParityGoal.allEven(41);
    Triangulation best =
        BestTriangulation.of(sites, goal, SearchLimits.DEFAULT, NONE).triangulation();
    List<LocalBound> windows = SiteBounds.ofWindows(best, goal, NONE).windows();
    BoundCheck check = BoundCheck.of(sites, goal, 4, windows, NONE);
    assertThat(check.verdict()).isEqualTo(Verdict.RECOMPUTED);
    assertThat(check.recomputed().windows()).isEqualTo(windows);
  }
}
