package dct.core.degree.region;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Triangulation;
import java.util.concurrent.CancellationException;

/**
 * Improves a triangulation of a polygon too large for one {@link ParityTable}: again and again, the
 * triangles round an unsatisfied vertex are put back in the best way there is ({@link
 * RegionSearch}).
 *
 * <p>Never gets worse. A round visits the vertices that are unsatisfied when it comes to them; once
 * two rounds have gained little, the regions become larger. The search ends when the largest ones
 * gain little, or the bound is met.
 */
public final class PolygonImprover {
  private static final int[] REGION_SIZES = {60, 150, 400, 1000};
  private static final int IDLE_ROUNDS = 2;

  private final SimplePolygon polygon;
  private final ParityGoal goal;
  private final SearchLimits limits;
  private final Progress progress;

  public PolygonImprover(
      SimplePolygon polygon, ParityGoal goal, SearchLimits limits, Progress progress) {
    this.polygon = polygon;
    this.goal = goal;
    this.limits = limits;
    this.progress = progress;
  }

  /**
   * The best triangulation found, never worse than {@code start}; stops where no more than {@code
   * bound} are unsatisfied, or the progress asks to stop.
   */
  public Triangulation run(Triangulation start, int bound) {
    SeededRandom random = new SeededRandom(limits.seed());
    RegionSearch search = new RegionSearch(start, goal, random, progress);
    try {
      improve(search, random, bound);
    } catch (CancellationException e) {
      return search.triangulation();
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
