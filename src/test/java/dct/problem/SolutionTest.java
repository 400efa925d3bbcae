package dct.problem;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.degree.DegreeCount;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.geometry.InvalidGeometryException;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.RandomSites;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** An instance is judged, a method triangulates it, a solution tells how it came to be. */
class SolutionTest {
  private static final Points HEXAGON = Points.ofPairs(0, 0, 5, -2, 9, 1, 10, 6, 4, 9, -1, 5);

  @Test
  void example() {
    Instance hexagon = Instance.of(Domain.POLYGON, "hexagon", HEXAGON, Progress.NONE);
    Solution fan = Solution.of(hexagon, Method.CONVEX_ODD, Progress.NONE);
    Solution best = fan.optimized(SearchLimits.DEFAULT, Progress.NONE);
    assertThat(fan.counts()).isEqualTo(new DegreeCount(2, 4));
    assertThat(best.counts()).isEqualTo(new DegreeCount(6, 0));
    assertThat(best.isProven()).isTrue();
  }

  private static Instance instance(Domain domain) {
    Points points = domain == Domain.POLYGON ? HEXAGON : RandomSites.uniform(40, 3);
    return Instance.of(domain, "x", points, Progress.NONE);
  }

  @ParameterizedTest
  @EnumSource(Method.class)
  void everyMethodTriangulatesItsDomainAndNoOther(Method method) {
    Instance mine = instance(method.application());
    Solution solution = Solution.of(mine, method, Progress.NONE);
    assertThat(solution.triangulation().domain()).isEqualTo(method.application());
    assertThat(solution.triangulation().vertexCount()).isEqualTo(mine.size());
    assertThat(Method.of(method.application(), method.word())).contains(method);
    Domain other = method.application() == Domain.POLYGON ? Domain.SITES : Domain.POLYGON;
    assertThat(Method.of(other, method.word())).isEmpty();
    Instance foreign = instance(other);
    assertThatThrownBy(() -> method.run(foreign, Progress.NONE))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(method.word() + " is not for " + other.word());
  }

  @Test
  void theDefaultsAreThoseOfTheThesis() {
    assertThat(Method.byDefault(Domain.POLYGON)).isEqualTo(Method.MONOTONE);
    assertThat(Method.byDefault(Domain.SITES)).isEqualTo(Method.DELAUNAY);
  }

  @Test
  void columnsAreNamedAfterTheAlgorithms() {
    assertThat(Method.CONVEX_EVEN.column()).isEqualTo("partitioning_aqt");
    assertThat(Method.EAR_CLIPPING.column()).isEqualTo("ear_clipping");
  }

  @Test
  void flipsKeepTheCountsBefore() {
    Solution delaunay = Solution.of(instance(Domain.SITES), Method.DELAUNAY, Progress.NONE);
    Solution flipped = delaunay.flipped(Progress.NONE);
    assertThat(delaunay.countsBefore()).isEmpty();
    assertThat(flipped.countsBefore()).contains(delaunay.counts());
    assertThat(flipped.counts().even()).isGreaterThan(delaunay.counts().even());
  }

  @Test
  void onlyATriangulationWithOtherKindsOfEdgesIsMadePlain() {
    Solution delaunay = Solution.of(instance(Domain.SITES), Method.DELAUNAY, Progress.NONE);
    Triangulation flipped = delaunay.flipped(Progress.NONE).triangulation();
    assertThat(delaunay.triangulation().plain()).isSameAs(delaunay.triangulation());
    assertThat(flipped.count(EdgeKind.FLIPPED)).isPositive();
    assertThat(flipped.plain().count(EdgeKind.FLIPPED)).isZero();
    assertThat(flipped.plain().dcel()).isSameAs(flipped.dcel());
  }

  @Test
  void withoutASearchTheBoundFollowsFromTheBoundary() {
    Points pentagon = Points.ofPairs(0, 0, 5, -2, 9, 1, 4, 9, -1, 5);
    Instance five = Instance.of(Domain.POLYGON, "", pentagon, Progress.NONE);
    assertThat(Solution.of(five, Method.MONOTONE, Progress.NONE).oddBound().value()).isEqualTo(2);
    Solution six = Solution.of(instance(Domain.POLYGON), Method.MONOTONE, Progress.NONE);
    assertThat(six.oddBound().value()).isZero();
  }

  @Test
  void wishesGoWithTheInstance() {
    Instance odd = instance(Domain.POLYGON).with(ParityGoal.allOdd(6));
    Solution best =
        Solution.of(odd, Method.MONOTONE, Progress.NONE)
            .optimized(SearchLimits.DEFAULT, Progress.NONE);
    assertThat(best.optimum().orElseThrow().goal()).isEqualTo(ParityGoal.allOdd(6));
    assertThat(best.counts().odd()).isEqualTo(4); // two ears have even tips
    assertThat(best.wished()).isPresent();
    assertThat(best.isProven()).isTrue();
  }

  @Test
  void duplicatesAmongSitesAreMerged() {
    Points twice = Points.ofPairs(0, 0, 4, 0, 0, 4, 4, 0);
    Instance sites = Instance.of(Domain.SITES, "", twice, Progress.NONE);
    assertThat(sites.size()).isEqualTo(3);
    assertThat(sites.description()).isEqualTo("3 usable sites (1 duplicate merged)");
  }

  @Test
  void unusablePointsAreRefusedInTheWordsOfTheirDomain() {
    assertRefused(Domain.SITES, "all sites lie on one line", 0, 0, 1, 1, 2, 2, 1, 1);
    assertRefused(Domain.SITES, "2 sites; three or more", 0, 0, 1, 1);
    assertRefused(Domain.POLYGON, "all vertices lie on one line", 0, 0, 1, 1, 2, 2);
    assertRefused(Domain.POLYGON, "edges v0–v1 and v2–v3 cross", 0, 0, 4, 4, 4, 0, 0, 4);
  }

  private static void assertRefused(Domain domain, String what, double... pairs) {
    assertThatThrownBy(() -> Instance.of(domain, "", Points.ofPairs(pairs), Progress.NONE))
        .isInstanceOf(InvalidGeometryException.class)
        .hasMessageContaining(what);
  }
}
