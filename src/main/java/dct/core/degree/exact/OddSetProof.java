package dct.core.degree.exact;

import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.exact.OddSetSearch.Outcome;
import dct.core.triangulate.Triangulation;
import java.util.BitSet;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/**
 * Raises a bound by refuting all sets of so many unmet sites, up to the number that is known to be
 * possible; or finds a triangulation with fewer.
 */
public final class OddSetProof {
  private static final long STEPS = 30_000_000; // some seconds

  private final ParityGoal goal;
  private Optimum known;

  private OddSetProof(Optimum known) {
    this.known = known;
    goal = known.goal();
  }

  /**
   * What is known, improved as far as some seconds suffice; the same if the sites are too many.
   *
   * @param known a triangulation of sites with a triangle, and a bound that is rounded up to a
   *     number of unmet wishes that the handshake lemma allows
   * @param effort above 1, how many times as long; less is not given, so that a check proves what
   *     an ordinary search has proven
   * @param progress if it asks to stop, what was proven until then is returned
   */
  public static Optimum improve(Optimum known, double effort, Progress progress) {
    OddSetProof proof = new OddSetProof(known);
    try {
      Optional<OddSetSearch> search =
          OddSetSearch.of(known.triangulation(), known.goal(), progress);
      search.ifPresent(sets -> proof.run(sets, (long) (STEPS * Math.max(1, effort))));
    } catch (CancellationException e) {
      return proof.known;
    }
    return proof.known;
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

  private void run(OddSetSearch sets, long mostSteps) {
    boolean goesOn = true;
    while (goesOn && !known.isProven()) {
      int unmet = known.bound().value();
      switch (sets.search(unmet, mostSteps)) {
        case FOUND -> known = Optimum.of(sets.found(), goal, known.bound());
        case REFUTED ->
            known =
                withBound(new LowerBound(unmet + stride(goal), "refuted: " + refuted(goal, unmet)));
        case OPEN -> goesOn = false;
      }
    }
  }

  private Optimum withBound(LowerBound bound) {
    return new Optimum(known.triangulation(), goal, known.unmet(), bound, false);
  }

  /** The numbers of unmet wishes differ by this: that of odd vertices is even. */
  private static int stride(ParityGoal goal) {
    return goal.count(Wish.ANY) > 0 ? 1 : 2;
  }

  private static String refuted(ParityGoal goal, int most) {
    String unmet = goal.isAll(Wish.EVEN) ? "odd" : "unmet";
    if (most == 0) {
      return "no " + unmet + " vertex";
    }
    return String.format(
        Locale.ROOT, "%,d sets of at most %d %s vertices", sets(goal, most), most, unmet);
  }

  /** The number of sets of at most so many sites with a wish that the handshake lemma allows. */
  private static long sets(ParityGoal goal, int most) {
    int n = goal.size() - goal.count(Wish.ANY);
    long sum = 0;
    long choose = 1;
    for (int k = 0; k <= most; k++) {
      sum += (most - k) % stride(goal) == 0 ? choose : 0;
      choose = choose * (n - k) / (k + 1);
    }
    return sum;
  }
}
