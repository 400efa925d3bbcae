package dct.core.degree.bound;

import dct.core.Progress;
import dct.core.degree.LocalBound;
import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.HullRing;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/**
 * The best lower bound known for the number of sites that miss their wished parity in any
 * triangulation of them.
 *
 * <p>The largest of: the boundary count modulo 3 ({@link BoundaryColouring}); the sum of the
 * degrees ({@link DegreeSumBound}); a long straight side ({@link LongSideBound}); the triangles
 * along the hull ({@link HullWalkBound}); full lattice polygons ({@link LatticeBound}); three hull
 * sites ({@link ThreeHullSites}); each rounded up by the {@link Handshake} lemma. Each class proves
 * its bound, for all wishes even and for the other goals to which it applies. Exact. Sites on one
 * line have one triangulation, whose count is the bound.
 *
 * <p>All but the hull walk take O(n) time. The walk is left out where it would cost more than about
 * a second, as at 10⁵ sites.
 */
public final class SiteBounds {
  private final HullRing ring;
  private final ParityGoal goal;
  private final Handshake handshake;
  private LowerBound best;

  private SiteBounds(Triangulation triangulation, ParityGoal goal, LowerBound known) {
    this.goal = goal;
    ring = HullRing.of(triangulation);
    handshake = new Handshake(goal);
    best = known;
  }

  /**
   * The largest of all the bounds. If the hull walk was left out the reason says so.
   *
   * @param triangulation any triangulation of the sites
   * @param progress if it asks to stop, the bounds that are not computed yet are left out too
   * @throws IllegalArgumentException if it is one of a polygon, or has another number of vertices
   */
  public static LowerBound of(Triangulation triangulation, ParityGoal goal, Progress progress) {
    return walked(triangulation, goal, quick(triangulation, goal, progress), progress);
  }

  /**
   * The same, where those that take linear time are computed.
   *
   * @param quick what {@link #quick} has said, or a larger bound
   */
  public static LowerBound walked(
      Triangulation triangulation, ParityGoal goal, LowerBound quick, Progress progress) {
    check(triangulation, goal);
    return isPath(triangulation)
        ? onePath(triangulation, goal)
        : new SiteBounds(triangulation, goal, quick).walk(progress);
  }

  /**
   * The bound from windows that cannot be granted all wishes ({@link WindowBound}): some seconds
   * for a hundred sites, and zero where it is too much to compute.
   *
   * @param best the best triangulation of the sites that is known, with at least one triangle
   * @throws CancellationException if cancelled
   */
  public static LowerBound ofWindows(Triangulation best, ParityGoal goal, Progress progress) {
    check(best, goal);
    return new Handshake(goal).roundUp(WindowBound.of(HullRing.of(best), goal, progress));
  }

  /**
   * The sum of those windows that are proven again in some seconds, rounded up.
   *
   * @param any any triangulation of the sites, with at least one triangle
   * @param windows windows that someone claims; those that are not convex, or have a site of one
   *     before, count for nothing
   * @throws CancellationException if cancelled
   */
  public static LowerBound ofWindows(
      Triangulation any, ParityGoal goal, List<LocalBound> windows, Progress progress) {
    check(any, goal);
    return new Handshake(goal)
        .roundUp(WindowBound.ofClaims(HullRing.of(any), goal, windows, progress));
  }

  /**
   * The edges of the triangles in a cheapest walk round the hull, two sites an edge, in the order
   * of the walk; those at different hull sites may cross. Up to about a second.
   *
   * @param any any triangulation of the sites, with at least one triangle
   * @return none if that is too much to compute
   * @throws CancellationException if cancelled
   */
  public static int[] walkedEdges(Triangulation any, ParityGoal goal, Progress progress) {
    check(any, goal);
    return HullWalkBound.leastWalk(HullRing.of(any), goal, progress)
        .flatMap(HullWalkBound.Least::route)
        .map(HullRoute::edges)
        .orElseGet(() -> new int[0]);
  }

  /**
   * The largest of the bounds that take linear time, without the hull walk: enough to see that a
   * triangulation which attains it is the best.
   *
   * @param triangulation any triangulation of the sites
   * @param progress if it asks to stop, the bounds that are not computed yet are left out
   * @throws IllegalArgumentException if it is one of a polygon, or has another number of vertices
   */
  public static LowerBound quick(Triangulation triangulation, ParityGoal goal, Progress progress) {
    check(triangulation, goal);
    if (isPath(triangulation)) {
      return onePath(triangulation, goal);
    }
    SiteBounds bounds = new SiteBounds(triangulation, goal, new LowerBound(0, "handshake lemma"));
    try {
      bounds.improveQuickly(progress);
    } catch (CancellationException e) {
      return bounds.best;
    }
    return bounds.best;
  }

  private static void check(Triangulation triangulation, ParityGoal goal) {
    if (triangulation.domain() != Domain.SITES || triangulation.vertexCount() != goal.size()) {
      throw new IllegalArgumentException("these are not wishes for a triangulation of sites");
    }
  }

  private static boolean isPath(Triangulation triangulation) {
    return triangulation.triangleCount() == 0;
  }

  private static LowerBound onePath(Triangulation triangulation, ParityGoal goal) {
    return new LowerBound(goal.unmet(triangulation), "all sites on one line");
  }

  private void improveQuickly(Progress progress) {
    best = handshake.roundUp(BoundaryColouring.ofSites(ring, goal));
    progress.checkCancelled();
    improve(DegreeSumBound.of(ring, goal));
    improve(LongSideBound.of(ring, goal));
    improve(LatticeBound.of(ring, goal, progress));
    improve(ThreeHullSites.of(ring, goal, best.value()));
  }

  private void improve(LowerBound bound) {
    best = best.max(handshake.roundUp(bound));
  }

  private LowerBound walk(Progress progress) {
    Optional<LowerBound> walked;
    try {
      walked = HullWalkBound.ofWalk(ring, goal, best.value(), progress);
      walked.or(() -> HullWalkBound.ofStrips(ring, goal, progress)).ifPresent(this::improve);
    } catch (CancellationException e) {
      return best;
    }
    improve(ThreeHullSites.of(ring, goal, goal.isAll(Wish.EVEN) ? best.value() : 0));
    return walked.isPresent() ? best : notWalked(best);
  }

  private static LowerBound notWalked(LowerBound bound) {
    return new LowerBound(bound.value(), bound.reason() + "; too many sites for a hull walk");
  }
}
