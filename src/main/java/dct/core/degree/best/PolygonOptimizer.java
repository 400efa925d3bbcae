package dct.core.degree.best;

import dct.core.Deadline;
import dct.core.Progress;
import dct.core.degree.Aqt;
import dct.core.degree.ConvexPieces;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.PartitioningAqt;
import dct.core.degree.Preference;
import dct.core.degree.Preferred;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.PolygonBounds;
import dct.core.degree.region.ParityTable;
import dct.core.degree.region.PolygonImprover;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.core.triangulate.VisibilityGraph;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/**
 * The triangulation of a simple polygon in which the most vertices have the parity wished.
 *
 * <p>Takes any simple polygon. A strictly convex one whose vertices shall all be even is handed to
 * {@link Aqt}, which is optimal there. Otherwise the exact table over the pairs of vertices that
 * see each other ({@link ParityTable}) gives the optimum, proven, if its pairs and its steps stay
 * within the fixed budget of {@link SearchLimits}, which is checked first ({@link ExactPolygon}).
 * Larger polygons go to {@link PolygonImprover}, whose result is the best found, with the bound of
 * {@link PolygonBounds}.
 *
 * <p>The thesis's own algorithms come first, then the table over the pairs whose segment crosses
 * few edges of the best so far, all in time near linear. Where the result meets the bound, that
 * proves it and nothing else is done. What comes back is never worse than the best of those that
 * were done; a large polygon whose table is filled in well under a second does without them, unless
 * there is a time limit. Deterministic for the seed and effort, unless the time limit or a cancel
 * ends it early: then the best so far is returned at once, marked as interrupted. The start and one
 * Scan-Flip of it come first; for this the time limit waits a tenth of a second.
 */
public final class PolygonOptimizer {
  /** So many vertices take the thesis's algorithms a few milliseconds. */
  private static final int SMALL = 10_000;

  /** Of a table that is filled in well under a second. */
  private static final long QUICK_STEPS = 100_000_000;

  /** So many edges of a triangulation may be crossed by those of one that is near to it. */
  private static final int MOST_CROSSED = 3;

  /** A vertex: what finding the best near triangulation may take. */
  private static final long NEAR_PAIRS = 100;

  private static final long NEAR_STEPS = 2_000;

  /** Of a table of two costs that is filled where one of a single cost is not needed. */
  private static final long PREFERRED_STEPS = 400_000_000;

  private final SimplePolygon polygon;
  private final ParityGoal goal;
  private final SearchLimits limits;
  private final Preference preference; // null if there is none
  private final Deadline clock;
  private final Deadline early; // for what comes first, however short the limit is
  private final LowerBound bound;
  private final ExactPolygon exact;
  private Triangulation best;
  private boolean hasThesisBest;
  private boolean isMostPreferred; // by the table

  private PolygonOptimizer(
      SimplePolygon polygon,
      Triangulation start,
      ParityGoal goal,
      SearchLimits limits,
      Preference preference,
      Progress progress) {
    this.polygon = polygon;
    this.goal = goal;
    this.limits = limits;
    this.preference = preference;
    clock = new Deadline(progress, limits.seconds());
    early = new Deadline(progress, Math.max(SearchLimits.GRACE, limits.seconds()));
    bound = PolygonBounds.of(polygon.size(), goal);
    exact = new ExactPolygon(polygon, goal);
    best = start;
  }

  /**
   * The best triangulation, or the best found within the limits.
   *
   * @param start any triangulation of the polygon
   */
  public static Optimum optimize(
      SimplePolygon polygon,
      Triangulation start,
      ParityGoal goal,
      SearchLimits limits,
      Progress progress) {
    return new PolygonOptimizer(polygon, start, goal, limits, null, progress).run();
  }

  /**
   * The best triangulation, and among several equally good ones the most preferred; or the best
   * found within the limits.
   *
   * @param start any triangulation of the polygon
   */
  static Preferred optimize(
      SimplePolygon polygon,
      Triangulation start,
      ParityGoal goal,
      SearchLimits limits,
      Preference preference,
      Progress progress) {
    PolygonOptimizer optimizer =
        new PolygonOptimizer(polygon, start, goal, limits, preference, progress);
    Optimum optimum = optimizer.run();
    return optimizer.isMostPreferred
        ? Preferred.of(optimum, preference, true)
        : PreferredRegions.improve(optimum, preference, limits, optimizer.clock);
  }

  /**
   * The proven optimum, or empty if the table would be too large.
   *
   * @param any a triangulation of the polygon
   * @throws CancellationException if cancelled
   */
  static Optional<Optimum> exact(
      SimplePolygon polygon, ParityGoal goal, Triangulation any, Progress progress) {
    if (isSolvedByAqt(polygon, goal)) {
      return Optional.of(aqt(polygon, goal, progress));
    }
    ExactPolygon exact = new ExactPolygon(polygon, goal);
    return Optional.ofNullable(exact.graph(any, progress))
        .map(graph -> exact.proven(exact.best(graph, progress)));
  }

  /**
   * The most preferred of the best triangulations, proven, or empty if the table would be too
   * large.
   *
   * @throws CancellationException if cancelled
   */
  static Optional<Preferred> mostPreferred(
      SimplePolygon polygon, ParityGoal goal, Preference preference, Progress progress) {
    Triangulation any = MonotoneTriangulation.triangulate(polygon, progress);
    ExactPolygon exact = new ExactPolygon(polygon, goal);
    return Optional.ofNullable(exact.graph(any, progress))
        .filter(ExactPolygon::canPrefer)
        .map(graph -> exact.proven(exact.best(graph, preference, progress)))
        .map(best -> Preferred.of(best, preference, true));
  }

  // ---- strictly convex, all even

  private static boolean isSolvedByAqt(SimplePolygon polygon, ParityGoal goal) {
    return goal.isAll(ParityGoal.Wish.EVEN) && ConvexPieces.isConvex(polygon);
  }

  private static Optimum aqt(SimplePolygon polygon, ParityGoal goal, Progress progress) {
    Triangulation made = Aqt.triangulate(polygon, progress);
    LowerBound bound = PolygonBounds.of(polygon.size(), goal);
    return new Optimum(made, goal, goal.unmet(made), bound, false);
  }

  // ---- everything

  private Optimum run() {
    try {
      if (isSolvedByAqt(polygon, goal)) {
        best = Aqt.triangulate(polygon, early);
      } else {
        takeWhatIsQuick();
      }
      boolean isMet = goal.unmet(best) == bound.value();
      if (isMet && preference == null) {
        return found(false);
      }
      VisibilityGraph graph = exact.graph(best, clock);
      if (!isMet && (graph == null || ParityTable.steps(graph) > QUICK_STEPS)) {
        takeThesisBest();
      }
      if (prefersByTable(graph, isMet)) {
        return mostPreferred(graph, isMet);
      }
      if (graph != null && !isMet) {
        return exact.proven(exact.best(graph, clock));
      }
      best = new PolygonImprover(goal, limits, clock).run(best, bound.value());
    } catch (CancellationException e) {
      return found(true);
    }
    return found(clock.hasStruck());
  }

  private void takeWhatIsQuick() {
    if (Double.isFinite(limits.seconds()) || polygon.size() <= SMALL) {
      takeThesisBest();
    }
    takeNearBest();
  }

  /** Whether the table of two costs is filled: where the bound is met only if it takes little. */
  private boolean prefersByTable(VisibilityGraph graph, boolean isMet) {
    return preference != null
        && graph != null
        && ExactPolygon.canPrefer(graph)
        && (!isMet || ParityTable.steps(graph) <= PREFERRED_STEPS);
  }

  /** By the table of two costs; where time is limited, the faster one of one cost comes first. */
  private Optimum mostPreferred(VisibilityGraph graph, boolean isMet) {
    Optimum known = isMet ? found(false) : null;
    if (!isMet && Double.isFinite(limits.seconds())) {
      known = exact.proven(exact.best(graph, clock));
    }
    try {
      known = exact.proven(exact.best(graph, preference, clock));
      isMostPreferred = true;
      return known;
    } catch (CancellationException e) {
      if (known == null) {
        throw e;
      }
      return known;
    }
  }

  private Optimum found(boolean interrupted) {
    return new Optimum(best, goal, goal.unmet(best), bound, interrupted);
  }

  /** The best of what the thesis's own algorithms make of the polygon, made once. */
  private void takeThesisBest() {
    if (hasThesisBest) {
      return;
    }
    hasThesisBest = true;
    take(ScanFlip.run(best, early).after());
    Triangulation monotone = MonotoneTriangulation.triangulate(polygon, clock);
    takeFlipped(monotone);
    Triangulation pieces = PartitioningAqt.triangulate(Region.of(polygon), monotone, clock);
    take(pieces);
    takeFlipped(pieces);
    takeFlipped(EarClipping.triangulate(polygon, clock));
  }

  /**
   * If the bound is not met: the best triangulation whose edges each cross few of the best one's.
   * Near linear; where all pairs see each other, this usually meets the bound.
   */
  private void takeNearBest() {
    if (goal.unmet(best) == bound.value()) {
      return;
    }
    long mostPairs = NEAR_PAIRS * polygon.size();
    VisibilityGraph near = VisibilityGraph.within(polygon, best, MOST_CROSSED, mostPairs, clock);
    if (near != null && ParityTable.steps(near) <= NEAR_STEPS * polygon.size()) {
      take(exact.best(near, clock));
    }
  }

  private void takeFlipped(Triangulation other) {
    take(ScanFlip.run(other, clock).after());
  }

  private void take(Triangulation other) {
    best = goal.unmet(other) < goal.unmet(best) ? other : best;
  }
}
