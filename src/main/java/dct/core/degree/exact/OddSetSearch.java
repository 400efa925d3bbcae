package dct.core.degree.exact;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.OddSites;
import dct.core.degree.colour.OddSites.Answer;
import dct.core.degree.colour.OddSites.Answer.Found;
import dct.core.degree.colour.OddSites.Answer.Refuted;
import dct.core.degree.colour.OddSites.Window;
import dct.core.triangulate.Triangulation;
import java.util.BitSet;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;

/**
 * Finds a triangulation of sites, or of a region, with at most so many unmet wishes, or proves that
 * there is none; or that there is none with so few in a window of sites. The vertices of a region
 * are sites here, those on its rings as well.
 *
 * <p>Tries sets of unmet sites: first none, and then, each set being refuted, those with one site
 * more. A refutation names the sites that matter to it ({@link
 * dct.core.degree.colour.Refutation#support}); so of every larger set that has a triangulation one
 * of these must be a member, and only they are added, beginning with the least such set of all that
 * refute the present one. A site that was added in vain is left out of what follows. Where more
 * disjoint supports refute a set than sites can still be added, nothing is tried. Sites without a
 * wish are added at no cost.
 *
 * <p>Exact for every goal; deterministic. The time depends on how many sets must be looked at: few
 * if the optimum is small or each refutation says much, and up to all n over k.
 */
public final class OddSetSearch {
  private static final int MOST_SITES = 600;
  private static final int MOST_TRIANGLES = 150_000;
  private static final long FIRST_STEPS = 1_000_000; // for one set
  private static final int MORE_STEPS = 8; // times as many, the next time

  /** How the search for at most so many unmet wishes ended. */
  public enum Outcome {
    /** There is no such triangulation. */
    REFUTED,
    /** One was found. */
    FOUND,
    /** It would take more steps. */
    OPEN
  }

  private final OddSites sites;
  private final Window window;
  private final int[] first; // sites in the order in which they are added
  private final LearnedSets learned;
  private final BitSet added = new BitSet();
  private final BitSet excluded = new BitSet();
  private final BitSet all = new BitSet(); // those that can be added
  private final BitSet free = new BitSet(); // those without a wish
  private final Progress progress;
  private long budget; // of steps
  private long limit; // of steps
  private long steps; // those of this class
  private long each; // steps for one set
  private int sought = -1; // most unmet wishes of the last search
  private final Set<BitSet> passedOver = new HashSet<>(); // they take more steps than that
  private Triangulation found;

  private OddSetSearch(OddSites sites, Window window, ParityGoal goal, Progress progress) {
    this.sites = sites;
    this.window = window;
    this.progress = progress;
    BitSet odd = new BitSet();
    for (int v : window.sites().stream().toArray()) {
      odd.set(v, goal.wish(v) == Wish.ODD);
      free.set(v, goal.wish(v) == Wish.ANY);
    }
    free.or(window.gaps());
    all.or(window.sites());
    all.or(window.gaps());
    first = order(goal);
    learned = new LearnedSets(all, odd);
  }

  /**
   * Gets ready; empty if there are too many sites or triangles.
   *
   * @param start a triangulation of the sites with a triangle; its unmet sites are tried first
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optional<OddSetSearch> of(Triangulation start, ParityGoal goal, Progress progress) {
    BitSet all = new BitSet();
    all.set(0, start.vertexCount());
    return start.vertexCount() > MOST_SITES
        ? Optional.empty()
        : OddSites.of(start, MOST_TRIANGLES, progress)
            .map(sites -> within(sites, all, goal, progress));
  }

  /**
   * A search that counts the unmet wishes in a window only, and never finds a triangulation unless
   * all sites are in it.
   *
   * @param within the sites in an open convex region
   */
  public static OddSetSearch within(
      OddSites sites, BitSet within, ParityGoal goal, Progress progress) {
    return new OddSetSearch(sites, sites.window(within), goal, progress);
  }

  private int[] order(ParityGoal goal) {
    Triangulation start = sites.triangulation();
    int[] order = new int[all.cardinality()];
    int size = 0;
    for (boolean granted : new boolean[] {false, true}) {
      for (int v : all.stream().toArray()) {
        if (goal.isGranted(start, v) == granted) {
          order[size++] = v;
        }
      }
    }
    return order;
  }

  /**
   * Looks for a triangulation with at most so many unmet wishes. What was learned before is used,
   * and a search for the same number goes on where it stopped.
   *
   * <p>Goes through the sets several times, each time with more steps for one of them: where there
   * are such triangulations those are found first that are easy to find.
   *
   * @param mostSteps give up after about so many
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Outcome search(int mostUnmet, long mostSteps) {
    budget = mostSteps;
    limit = steps() + mostSteps;
    if (mostUnmet != sought) {
      sought = mostUnmet;
      each = FIRST_STEPS;
      passedOver.clear();
    }
    excluded.clear();
    Outcome outcome = extend(mostUnmet);
    while (outcome == Outcome.REFUTED && !passedOver.isEmpty()) {
      each *= MORE_STEPS;
      passedOver.clear();
      outcome = extend(mostUnmet);
    }
    return outcome;
  }

  /** After FOUND with all sites: the triangulation. */
  public Triangulation found() {
    return found;
  }

  /** The fewest sites that matter to a refutation of the wishes as they are, if there is one. */
  BitSet fewestSites() {
    BitSet fewest = all;
    for (int j = 0; j < learned.size(); j++) {
      BitSet support = learned.get(j).support();
      boolean isSmaller = support.cardinality() < fewest.cardinality();
      fewest = learned.refutes(j) && isSmaller ? support : fewest;
    }
    return fewest;
  }

  /** All steps so far, those of the sites included. */
  public long steps() {
    return steps + sites.steps();
  }

  /** The present set, and all with so many unmet sites more. */
  private Outcome extend(int more) {
    BitSet vain = new BitSet();
    Outcome outcome = null;
    while (outcome == null) {
      BitSet next = next(more);
      if (steps() > limit) {
        outcome = Outcome.OPEN;
      } else if (next == null && isEven() && !passedOver.contains(learned.set())) {
        outcome = decide();
      } else {
        int v = first(next == null ? others(all) : next, more);
        if (v < 0) {
          outcome = Outcome.REFUTED;
        } else {
          outcome = extendBy(v, more);
          excluded.set(v);
          vain.set(v);
        }
      }
    }
    excluded.andNot(vain);
    return outcome;
  }

  private boolean isEven() {
    return !window.isEven() || learned.set().cardinality() % 2 == 0;
  }

  /** Decides the present set; null if it is refuted, or takes too many steps for this time. */
  private Outcome decide() {
    progress.report(1 - (double) (limit - steps()) / budget, "Refuting sets of unmet vertices");
    long most = Math.min(each, limit - steps());
    Answer answer = sites.decide(window, learned.set(), most, progress);
    if (answer instanceof Found) {
      found = window.isAll() ? TriangleMesh.of(sites.triangulation(), sites.corners()) : null;
      return Outcome.FOUND;
    }
    if (answer instanceof Refuted refuted) {
      learned.add(refuted.by());
    } else if (most == each) {
      passedOver.add((BitSet) learned.set().clone());
    }
    return null;
  }

  /** Null if all sets with this site are refuted. */
  private Outcome extendBy(int v, int more) {
    added.set(v);
    learned.flip(v);
    Outcome outcome = extend(free.get(v) ? more : more - 1);
    learned.flip(v);
    added.clear(v);
    return outcome == Outcome.REFUTED ? null : outcome;
  }

  private BitSet others(BitSet sitesThere) {
    BitSet others = (BitSet) sitesThere.clone();
    others.and(all);
    others.andNot(excluded);
    others.andNot(added);
    return others;
  }

  private int first(BitSet next, int more) {
    for (int v : first) {
      if (next.get(v) && (more > 0 || free.get(v))) {
        return v;
      }
    }
    return -1;
  }

  /**
   * The fewest sites of which one must be added; empty if that cannot help, null if nothing refutes
   * the present set yet.
   */
  private BitSet next(int more) {
    progress.checkCancelled();
    steps += 1 + learned.size() / Long.SIZE;
    BitSet best = null;
    BitSet packed = new BitSet();
    int disjoint = 0;
    for (int j = 0; j < learned.size() && (best == null || !best.isEmpty()); j++) {
      if (learned.refutes(j)) {
        if (more == 0 && free.isEmpty()) {
          return new BitSet();
        }
        BitSet support = others(learned.get(j).support());
        best = best == null || support.cardinality() < best.cardinality() ? support : best;
        if (!support.intersects(packed) && !support.intersects(free)) {
          packed.or(support);
          if (++disjoint > more) {
            return new BitSet();
          }
        }
      }
    }
    return best;
  }
}
