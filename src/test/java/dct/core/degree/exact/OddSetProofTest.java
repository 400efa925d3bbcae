package dct.core.degree.exact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.bound.SmallSets;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.testing.CancelledAfter;
import dct.testing.TriangulationAssert;
import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;

/**
 * Proofs that no set of few vertices can be the odd ones:
 *
 * <pre>{@code
 * Optimum known = Optimum.of(triangulation, goal, new LowerBound(0, "handshake lemma"));
 * OddSetProof proof = OddSetProof.begin(triangulation, goal, Progress.NONE).orElseThrow();
 * Optimum better = proof.improve(known, OddSetProof.STEPS);
 * }</pre>
 */
class OddSetProofTest {
  private static final LowerBound NOTHING = new LowerBound(0, "handshake lemma");

  private static Triangulation triangulation(double... pairs) {
    return Delaunay.triangulate(Sites.of(Points.ofPairs(pairs), Progress.NONE), Progress.NONE);
  }

  private static Triangulation cross(int onArm) {
    return triangulation(SmallSets.cross(onArm, onArm));
  }

  private static Optimum improve(Triangulation start, ParityGoal goal) {
    return improve(start, goal, Progress.NONE);
  }

  private static Optimum improve(Triangulation start, ParityGoal goal, Progress progress) {
    Optimum known = Optimum.of(start, goal, NOTHING);
    return OddSetProof.begin(start, goal, progress)
        .map(proof -> proof.improve(known, OddSetProof.STEPS))
        .orElse(known);
  }

  @Test
  void findsTheOptimumOfACrossAndRefutesEverySmallerSet() {
    Triangulation start = cross(10);
    Optimum better = improve(start, ParityGoal.allEven(41));
    TriangulationAssert.assertThat(better.triangulation())
        .isTriangulationOf(Sites.of(start.points(), Progress.NONE));
    assertThat(better.unmet()).isEqualTo(4);
    assertThat(better.bound())
        .isEqualTo(new LowerBound(4, "refuted: 821 sets of at most 2 odd vertices"));
  }

  @Test
  void twoTrianglesWithOneSiteEachAreCounted() {
    Triangulation square = triangulation(0, 0, 1, 0, 1, 1, 0, 1);
    assertThat(improve(square, ParityGoal.allEven(4)).bound())
        .isEqualTo(new LowerBound(2, "refuted: no odd vertex"));
    assertThat(improve(square, ParityGoal.allOdd(4)).bound())
        .isEqualTo(new LowerBound(2, "refuted: no unmet vertex"));
  }

  @Test
  void aVertexWithoutAWishMayHaveEitherParity() {
    Triangulation square = triangulation(0, 0, 1, 0, 1, 1, 0, 1);
    ParityGoal free = ParityGoal.allEven(4).with(0, Wish.ANY).with(2, Wish.ANY);
    assertThat(improve(square, free).unmet()).isZero();
    ParityGoal neighbours = ParityGoal.allEven(4).with(0, Wish.ANY).with(1, Wish.ANY);
    Optimum one = improve(square, neighbours);
    assertThat(one.unmet()).isEqualTo(1);
    assertThat(one.isProven()).isTrue();
  }

  @Test
  void theSameInputGivesTheSameTriangulation() {
    Triangulation start = triangulation(new Random(7).doubles(60).toArray());
    ParityGoal goal = ParityGoal.allEven(30);
    Optimum once = improve(start, goal);
    assertThat(once.isProven()).isTrue();
    Optimum again = improve(start, goal);
    assertThat(again.bound()).isEqualTo(once.bound());
    for (int e = 0; e < 2 * start.dcel().edgeCount(); e++) {
      assertThat(again.triangulation().dcel().target(e))
          .isEqualTo(once.triangulation().dcel().target(e));
    }
  }

  @Test
  void whatIsProvenBeforeACancelIsKept() {
    Triangulation start = cross(10);
    ParityGoal goal = ParityGoal.allEven(41);
    assertThatThrownBy(() -> improve(start, goal, new CancelledAfter(0)))
        .isInstanceOf(CancellationException.class);
    int[] proven =
        Arrays.stream(new int[] {100, 400, 4000})
            .map(asked -> improve(start, goal, new CancelledAfter(asked)).bound().value())
            .toArray();
    assertThat(proven).isSorted().contains(2);
  }

  @Test
  void goesOnWhereItStopped() {
    Triangulation start = cross(10);
    ParityGoal goal = ParityGoal.allEven(41);
    OddSetProof proof = OddSetProof.begin(start, goal, Progress.NONE).orElseThrow();
    Optimum known = Optimum.of(start, goal, NOTHING);
    int parts = 0;
    while (!known.isProven() && parts < 1_000) {
      known = proof.improve(known, 3_000);
      parts++;
    }
    assertThat(known.bound())
        .isEqualTo(new LowerBound(4, "refuted: 821 sets of at most 2 odd vertices"));
    assertThat(known.unmet()).isEqualTo(4);
    assertThat(parts).isGreaterThan(1);
  }

  @Test
  void tooManySitesAreLeftAsTheyAre() {
    Triangulation start = triangulation(new Random(1).doubles(1400).toArray());
    assertThat(OddSetProof.begin(start, ParityGoal.allEven(700), Progress.NONE)).isEmpty();
  }

  /** More sets than a long can count. */
  @Test
  void theNumberOfSetsIsThatOfTheirBinomials() {
    assertThat(OddSetProof.refuted(ParityGoal.allEven(41), 2))
        .isEqualTo("821 sets of at most 2 odd vertices");
    assertThat(OddSetProof.refuted(ParityGoal.allEven(400), 12))
        .isEqualTo("more than 10^22 sets of at most 12 odd vertices");
  }
}
