package dct.core.degree.best;

import dct.core.Deadline;
import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.degree.Aqt;
import dct.core.degree.ConvexPieces;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.PolygonBounds;
import dct.core.degree.region.ParityTable;
import dct.core.degree.region.PolygonImprover;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.core.triangulate.VisibilityGraph;
import java.util.concurrent.CancellationException;

/**
 * The triangulation of a simple polygon in which the most vertices have the parity wished.
 *
 * <p>Takes any simple polygon. A strictly convex one whose vertices shall all be even is handed to
 * {@link Aqt}, which is optimal there. Otherwise the exact table over the pairs of vertices that
 * see each other ({@link ParityTable}) gives the optimum, proven, if its memory and its steps stay
 * within bounds that are checked first. Larger polygons go to {@link PolygonImprover}, whose result
 * is the best found, never worse than Scan-Flip on Partitioning-AQT, with the bound of {@link
 * PolygonBounds}.
 *
 * <p>Deterministic for the seed and effort, unless the time limit or a cancel ends it early: then
 * the best so far is returned at once, marked as interrupted.
 */
public final class PolygonOptimizer {
  private static final int BYTES_A_PAIR = 48;
  private static final long MOST_STEPS = 20_000_000_000L; // about a minute on two cores

  private final SimplePolygon polygon;
  private final ParityGoal goal;
  private final SearchLimits limits;
  private final Progress progress;

  private PolygonOptimizer(
      SimplePolygon polygon, ParityGoal goal, SearchLimits limits, Progress progress) {
    this.polygon = polygon;
    this.goal = goal;
    this.limits = limits;
    this.progress = new Deadline(progress, limits.seconds());
  }

  /** The best triangulation, or the best found within the limits. */
  public static Optimum optimize(
      SimplePolygon polygon, ParityGoal goal, SearchLimits limits, Progress progress) {
    return new PolygonOptimizer(polygon, goal, limits, progress).run();
  }

  private Optimum run() {
    LowerBound bound = PolygonBounds.of(polygon.size(), goal);
    if (goal.isAll(ParityGoal.Wish.EVEN) && ConvexPieces.isConvex(polygon)) {
      return optimum(Aqt.triangulate(polygon, progress), bound, false);
    }
    Triangulation start = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    try {
      Triangulation exact = exact(start);
      if (exact != null) {
        return optimum(exact, proven(exact, bound), false);
      }
      return improved(bound);
    } catch (CancellationException e) {
      return optimum(PolygonImprover.thesisBest(polygon, goal, start), bound, true);
    }
  }

  /** The exact optimum, or null if the table would be too large. */
  private Triangulation exact(Triangulation start) {
    VisibilityGraph graph = VisibilityGraph.of(polygon, start, mostPairs(), progress);
    if (graph == null || ParityTable.steps(graph) > MOST_STEPS) {
      return null;
    }
    ParityGoal.Wish[] wishes = new ParityGoal.Wish[polygon.size()];
    int[] corner = new int[wishes.length];
    for (int k = 0; k < wishes.length; k++) {
      wishes[k] = goal.wish(polygon.vertex(k));
      corner[k] = 2 * k; // of the cycle made below
    }
    ParityTable table = ParityTable.fill(graph, ParityTable.costs(wishes), new int[0], progress);
    Dcel dcel = Dcel.cycle(polygon.walk());
    table.cut(dcel, corner);
    return new Triangulation(Domain.POLYGON, polygon.points(), dcel, edge -> EdgeKind.DIAGONAL);
  }

  /** Half of the memory that the program may still take. */
  private static long mostPairs() {
    Runtime runtime = Runtime.getRuntime();
    long free = runtime.maxMemory() - runtime.totalMemory() + runtime.freeMemory();
    return Math.min(Integer.MAX_VALUE / 4, free / 2 / BYTES_A_PAIR);
  }

  private LowerBound proven(Triangulation exact, LowerBound bound) {
    int unsatisfied = goal.unsatisfied(exact);
    return bound.max(new LowerBound(unsatisfied, "exact table over all triangulations"));
  }

  private Optimum improved(LowerBound bound) {
    PolygonImprover improver = new PolygonImprover(polygon, goal, limits, progress);
    Triangulation best = improver.run(bound.value());
    return optimum(best, bound, improver.wasInterrupted());
  }

  private Optimum optimum(Triangulation best, LowerBound bound, boolean interrupted) {
    return new Optimum(best, goal, goal.unsatisfied(best), bound, interrupted);
  }
}
