package dct.problem;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.Flip;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class KnownBoundTest {
  private static final Points POLYGON =
      Points.ofPairs(
          100, 100, 300, 60, 500, 120, 560, 300, 800, 200, 900, 400, 850, 600, 600, 650, 450, 500);

  private static Solution solution(Domain domain, Points points) {
    Instance instance = Instance.of(domain, "-", points, Progress.NONE);
    return Solution.of(instance, Method.byDefault(domain), Progress.NONE);
  }

  /** The same after the first flip that there is from this edge on. */
  private static Optional<Solution> flipped(Solution solution, int from) {
    for (int edge = from; edge < solution.triangulation().edgeCount(); edge++) {
      if (Flip.at(solution.triangulation(), edge).isPresent()) {
        return Optional.of(solution.flippedAt(edge));
      }
    }
    return Optional.empty();
  }

  @Test
  void ofAPolygonItIsTheOptimumAndStaysWhateverIsFlipped() {
    Solution solution = solution(Domain.POLYGON, POLYGON);
    KnownBound bound = KnownBound.best(solution, Progress.NONE);
    Solution best = solution.optimized(SearchLimits.DEFAULT, Progress.NONE);
    assertThat(bound.bound().value()).isEqualTo(best.counts().odd());
    assertThat(bound.words(best)).isEqualTo("best possible");
    for (int edge = 0; edge < 12; edge += 3) {
      Solution other = flipped(solution, edge).orElseThrow();
      assertThat(bound.isOf(other)).isTrue();
      assertThat(KnownBound.best(other, Progress.NONE).bound().value())
          .isEqualTo(bound.bound().value());
      if (other.counts().odd() > bound.bound().value()) {
        assertThat(bound.words(other)).isEqualTo("at least " + bound.bound().value() + " odd");
      }
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void ofSitesItIsNeverAboveWhatIsFoundAndNeverBelowWhatTakesNoTime(long seed) {
    Solution delaunay = solution(Domain.SITES, RandomSites.uniform(12, seed));
    Solution best = delaunay.optimized(SearchLimits.DEFAULT, Progress.NONE);
    int bound = KnownBound.best(delaunay, Progress.NONE).bound().value();
    assertThat(bound).isBetween(KnownBound.quick(delaunay).bound().value(), best.counts().odd());
    assertThat(bound).isGreaterThanOrEqualTo(delaunay.bound().value());
  }

  @Test
  void whatAnOptimizerProvedIsKept() {
    Solution best =
        solution(Domain.SITES, RandomSites.uniform(12, 7))
            .optimized(SearchLimits.DEFAULT, Progress.NONE);
    assertThat(KnownBound.quick(best).bound().value()).isGreaterThanOrEqualTo(best.bound().value());
    assertThat(best.isProven()).isTrue();
    assertThat(KnownBound.quick(best).words(best)).isEqualTo("best possible");
  }

  @Test
  void otherPointsOtherWishesAndSitesInsteadOfAPolygonNeedAnother() {
    Solution solution = solution(Domain.POLYGON, POLYGON);
    KnownBound bound = KnownBound.quick(solution);
    assertThat(bound.isOf(solution)).isTrue();
    assertThat(bound.isOf(solution(Domain.POLYGON, POLYGON.moved(2, 500, 121)))).isFalse();
    assertThat(bound.isOf(solution(Domain.SITES, POLYGON))).isFalse();
    Solution mostOdd =
        solution
            .wishing(ParityGoal.allOdd(POLYGON.size()))
            .optimized(SearchLimits.DEFAULT, Progress.NONE);
    assertThat(bound.isOf(mostOdd)).isFalse();
    Solution worse = mostOdd;
    KnownBound even = KnownBound.quick(mostOdd);
    for (int edge = 0; worse.unmet() == mostOdd.unmet(); edge++) {
      worse = flipped(mostOdd, edge).orElseThrow();
    }
    assertThat(even.words(worse)).isEqualTo("at least " + even.bound().value() + " even");
  }
}
