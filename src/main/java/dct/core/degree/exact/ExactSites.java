package dct.core.degree.exact;

import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;

/**
 * The triangulation of a few sites that grants the most wishes: proven, for every goal.
 *
 * <p>Takes any triangulation of the sites, which may be degenerate in every way. Returns one with
 * the least number of unmet sites among all triangulations, with that number as its bound.
 *
 * <p>A triangulation is swept by paths that run through some of the sites in the order by x, or by
 * y: from the lower hull to the upper one, a triangle at a time. What lies below a path is finished
 * but for the degrees on the path itself, so it is enough to keep, for every path and all parities
 * on it, the least number of finished sites that miss their wish ({@link SweepTable}; the paths are
 * those of V. Alvarez and R. Seidel, <i>A Simple Aggregative Algorithm for Counting Triangulations
 * of Planar Point Sets and Related Problems</i>, 2013). At most 4·3ⁿ⁻² states, a byte each, and a
 * few steps for each: 20 MB and less than a second for n = 16. Sites on common lines have fewer
 * paths, so that some sets of up to 22 can be solved too, with 60 MB at most.
 *
 * <p>Ties break in favour of the triangle whose sites come first in the order of the sweep.
 */
public final class ExactSites {
  /** Up to this number every set of sites can be solved. */
  public static final int ALWAYS = 16;

  private static final int MOST_SITES = 22;

  private ExactSites() {}

  /**
   * Whether {@link #optimize} can solve these sites: always up to 16, depending on them up to 22.
   */
  public static boolean canSolve(Triangulation start) {
    return start.domain() == Domain.SITES && (isPath(start) || hasFewStates(start));
  }

  private static boolean isPath(Triangulation start) {
    return start.triangleCount() == 0;
  }

  private static boolean hasFewStates(Triangulation start) {
    return start.vertexCount() <= MOST_SITES && states(order(start)) <= SearchLimits.MOST_STATES;
  }

  /** The direction of the sweep that meets fewer states: across long rows rather than along. */
  private static SweepOrder order(Triangulation start) {
    SweepOrder alongX = SweepOrder.alongX(start.points());
    SweepOrder alongY = SweepOrder.alongY(start.points());
    return states(alongY) < states(alongX) ? alongY : alongX;
  }

  /** The number of pairs of a path and parities of its sites. */
  private static long states(SweepOrder sites) {
    long[] upTo = new long[sites.size()]; // by the last site of the path
    upTo[0] = 2;
    for (int b = 1; b < upTo.length; b++) {
      for (int a = 0; a < b; a++) {
        upTo[b] += sites.sees(a, b) ? 2 * upTo[a] : 0;
      }
    }
    return upTo[upTo.length - 1];
  }

  /**
   * The best triangulation for a goal.
   *
   * @param start any triangulation of the sites
   * @throws IllegalArgumentException if {@link #canSolve} is false or the goal is of another size
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optimum optimize(Triangulation start, ParityGoal goal, Progress progress) {
    if (start.vertexCount() != goal.size() || !canSolve(start)) {
      throw new IllegalArgumentException(
          goal.size() + " wishes, " + start.vertexCount() + " sites: too many or not as many");
    }
    Triangulation best = isPath(start) ? start : sweep(start, goal, progress);
    int unmet = goal.unmet(best);
    return new Optimum(best, goal, unmet, bound(best, unmet), false);
  }

  private static Triangulation sweep(Triangulation start, ParityGoal goal, Progress progress) {
    SweepTable table = new SweepTable(order(start), goal);
    table.fill(progress);
    return TriangleMesh.of(start.points(), new SweepTrace(table).triangles());
  }

  private static LowerBound bound(Triangulation best, int unmet) {
    String reason =
        isPath(best)
            ? "all sites on one line"
            : "every triangulation of " + best.vertexCount() + " sites searched";
    return new LowerBound(unmet, reason);
  }
}
