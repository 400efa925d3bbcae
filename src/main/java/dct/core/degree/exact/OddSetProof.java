package dct.core.degree.exact;

import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.exact.OddSetSearch.Outcome;
import dct.core.triangulate.Triangulation;
import java.math.BigInteger;
import java.util.BitSet;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/**
 * Raises a bound by refuting all sets of so many unmet sites, up to the number that is known to be
 * possible; or finds a triangulation with fewer. Goes on for as many steps as it is given.
 */
public final class OddSetProof {
  /** The steps of an ordinary search, and of a check of what it has proven: some seconds. */
  public static final long STEPS = 40_000_000;

  private static final int READABLE = 15; // digits

  private final OddSetSearch sets;
  private final ParityGoal goal;

  private OddSetProof(OddSetSearch sets, ParityGoal goal) {
    this.sets = sets;
    this.goal = goal;
  }

  /**
   * Gets ready; empty if there are too many sites or triangles.
   *
   * @param best a triangulation of the sites with a triangle; its unmet sites are tried first
   * @param progress if it asks to stop, what was proven until then remains
   * @throws CancellationException if cancelled
   */
  public static Optional<OddSetProof> begin(
      Triangulation best, ParityGoal goal, Progress progress) {
    return OddSetSearch.of(best, goal, progress).map(sets -> new OddSetProof(sets, goal));
  }

  /**
   * What is known, improved as far as so many steps suffice. Asked again, goes on.
   *
   * @param known a triangulation and a bound that is rounded up to a number of unmet wishes that
   *     the handshake lemma allows
   */
  public Optimum improve(Optimum known, long mostSteps) {
    Optimum best = known;
    long limit = sets.steps() + mostSteps;
    boolean goesOn = true;
    try {
      while (goesOn && !best.isProven() && sets.steps() < limit) {
        int unmet = best.bound().value();
        switch (sets.search(unmet, limit - sets.steps())) {
          case FOUND -> best = Optimum.of(sets.found(), goal, best.bound());
          case REFUTED -> best = withBound(best, unmet);
          case OPEN -> goesOn = false;
        }
      }
    } catch (CancellationException e) {
      return best;
    }
    return best;
  }

  private Optimum withBound(Optimum known, int refuted) {
    LowerBound bound = new LowerBound(refuted + stride(goal), "refuted: " + refuted(goal, refuted));
    return new Optimum(known.triangulation(), goal, known.unmet(), bound, false);
  }

  /**
   * The proof that no triangulation has fewer unmet wishes than a number.
   *
   * @param title what was refuted
   * @param sites those on which the refutation of no unmet wish rests that needs the fewest
   */
  public record Proof(String title, BitSet sites) {}

  /**
   * Proves a bound anew.
   *
   * @param any a triangulation of sites with a triangle
   * @param value the bound, more than 0
   * @return empty if it cannot be proven this way in some seconds
   * @throws CancellationException if cancelled
   */
  public static Optional<Proof> of(
      Triangulation any, ParityGoal goal, int value, Progress progress) {
    int most = value - stride(goal);
    return OddSetSearch.of(any, goal, progress)
        .filter(sets -> most >= 0 && sets.search(most, STEPS) == Outcome.REFUTED)
        .map(sets -> new Proof(refuted(goal, most), sets.fewestSites()));
  }

  /** The numbers of unmet wishes differ by this: that of odd vertices is even. */
  private static int stride(ParityGoal goal) {
    return goal.count(Wish.ANY) > 0 ? 1 : 2;
  }

  static String refuted(ParityGoal goal, int most) {
    String unmet = goal.isAll(Wish.EVEN) ? "odd" : "unmet";
    if (most == 0) {
      return "no " + unmet + " vertex";
    }
    return String.format(
        Locale.ROOT, "%s sets of at most %d %s vertices", number(sets(goal, most)), most, unmet);
  }

  /** The number of sets of at most so many sites with a wish that the handshake lemma allows. */
  private static BigInteger sets(ParityGoal goal, int most) {
    int n = goal.size() - goal.count(Wish.ANY);
    BigInteger sum = BigInteger.ZERO;
    BigInteger choose = BigInteger.ONE;
    for (int k = 0; k <= most; k++) {
      sum = (most - k) % stride(goal) == 0 ? sum.add(choose) : sum;
      choose = choose.multiply(BigInteger.valueOf(n - k)).divide(BigInteger.valueOf(k + 1));
    }
    return sum;
  }

  /** All digits of numbers that can still be read, of others the power of ten. */
  private static String number(BigInteger sets) {
    int digits = sets.toString().length();
    return digits <= READABLE
        ? String.format(Locale.ROOT, "%,d", sets)
        : "more than 10^" + (digits - 1);
  }
}
