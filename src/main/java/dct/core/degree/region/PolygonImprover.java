package dct.core.degree.region;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.degree.ParityGoal;
import dct.core.degree.PartitioningAqt;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import java.util.concurrent.CancellationException;

/**
 * Improves a triangulation of a polygon too large for one {@link ParityTable}: again and again, the
 * triangles round an unsatisfied vertex are put back in the best way there is ({@link
 * RegionSearch}).
 *
 * <p>Starts from the best of the thesis's own algorithms and never gets worse. A round visits the
 * vertices that are unsatisfied when it comes to them; once two rounds have gained little, the
 * regions become larger. The search ends when the largest ones gain little, or the bound is met.
 */
public final class PolygonImprover {
  private static final int[] REGION_SIZES = {60, 150, 400, 1000};
  private static final int IDLE_ROUNDS = 2;

  private final SimplePolygon polygon;
  private final ParityGoal goal;
  private final SearchLimits limits;
  private final Progress progress;
  private boolean interrupted;

  public PolygonImprover(
      SimplePolygon polygon, ParityGoal goal, SearchLimits limits, Progress progress) {
    this.polygon = polygon;
    this.goal = goal;
    this.limits = limits;
    this.progress = progress;
  }

  /** The best of what the thesis's own algorithms make of the polygon. */
  public static Triangulation thesisBest(
      SimplePolygon polygon, ParityGoal goal, Triangulation monotone) {
    Triangulation pieces = PartitioningAqt.triangulate(polygon, Progress.NONE);
    Triangulation clipped = EarClipping.triangulate(polygon, Progress.NONE);
    Triangulation best = monotone;
    for (Triangulation other :
        new Triangulation[] {
          ScanFlip.run(monotone, Progress.NONE).after(),
          pieces,
          ScanFlip.run(pieces, Progress.NONE).after(),
          ScanFlip.run(clipped, Progress.NONE).after()
        }) {
      best = goal.unsatisfied(other) < goal.unsatisfied(best) ? other : best;
    }
    return best;
  }

  /** Whether {@link #run} was ended by the time limit or a cancel. */
  public boolean wasInterrupted() {
    return interrupted;
  }

  /** The best triangulation found; stops where no more than {@code bound} are unsatisfied. */
  public Triangulation run(int bound) {
    Triangulation monotone = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    SeededRandom random = new SeededRandom(limits.seed());
    RegionSearch search =
        new RegionSearch(thesisBest(polygon, goal, monotone), goal, random, progress);
    try {
      improve(search, random, bound);
    } catch (CancellationException e) {
      interrupted = true;
    }
    return search.triangulation();
  }

  private void improve(RegionSearch search, SeededRandom random, int bound) {
    for (int size : REGION_SIZES) {
      int idle = 0;
      while (idle < IDLE_ROUNDS * limits.effort()) {
        int before = search.countUnsatisfied();
        if (before <= bound) {
          return;
        }
        round(search, random, size);
        int gained = before - search.countUnsatisfied();
        idle = gained > before / 50 ? 0 : idle + 1;
      }
    }
  }

  private void round(RegionSearch search, SeededRandom random, int size) {
    for (int k = 0; k < polygon.size(); k++) {
      int v = polygon.vertex(k);
      if (!search.isSatisfied(v)) {
        progress.report((double) k / polygon.size(), "Improving pieces of " + size + " vertices");
        progress.checkCancelled();
        search.solveAround(v, size / 2 + random.nextInt(size / 2 + 1));
      }
    }
  }
}
