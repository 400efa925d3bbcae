package dct.core.degree.region;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.triangulate.Triangulation;
import java.util.concurrent.CancellationException;

/**
 * Improves a triangulation of a polygon too large for one {@link ParityTable}: again and again, the
 * triangles round an unmet vertex are put back in the best way there is ({@link MeshRegion}).
 *
 * <p>Never gets worse. A round visits the vertices that are unmet when it comes to them; once two
 * rounds have gained little, the regions become larger. The search ends when the largest ones gain
 * little, or the bound is met. A region of m vertices costs at most m³/6 steps and in practice far
 * fewer; no step looks at the whole triangulation.
 */
public final class PolygonImprover {
  private static final int[] REGION_SIZES = {60, 150, 400, 1000};
  private static final int IDLE_ROUNDS = 2;
  private static final int TRIES = 20; // to grow by one vertex; most edges are the polygon's
  private static final int WEIGHT = 1 << 16; // of an unmet vertex, against noise
  private static final int NOISE_BITS = 4;

  private final ParityGoal goal;
  private final SearchLimits limits;
  private final Progress progress;

  public PolygonImprover(ParityGoal goal, SearchLimits limits, Progress progress) {
    this.goal = goal;
    this.limits = limits;
    this.progress = progress;
  }

  /**
   * The best triangulation found, never worse than {@code start}; stops where no more than {@code
   * bound} vertices are unmet, or the progress asks to stop.
   *
   * @throws CancellationException if cancelled before the search has begun
   */
  public Triangulation run(Triangulation start, int bound) {
    SearchMesh mesh = new SearchMesh(start, goal, WEIGHT, progress);
    try {
      improve(mesh, bound);
    } catch (CancellationException e) {
      return MeshExport.triangulation(mesh, start);
    }
    return MeshExport.triangulation(mesh, start);
  }

  private void improve(SearchMesh mesh, int bound) {
    SeededRandom random = new SeededRandom(limits.seed());
    int most = REGION_SIZES[REGION_SIZES.length - 1];
    MeshRegion region = new MeshRegion(mesh, random, progress, most, 0, mesh.size());
    int unmet = mesh.unmet();
    for (int size : REGION_SIZES) {
      int idle = 0;
      while (idle < IDLE_ROUNDS * limits.effort()) {
        if (unmet <= bound) {
          return;
        }
        int change = round(mesh, region, random, size);
        idle = -change > unmet / 50 ? 0 : idle + 1;
        unmet += change;
      }
    }
  }

  /** Solves a region round each vertex that is unmet when its turn comes. */
  private int round(SearchMesh mesh, MeshRegion region, SeededRandom random, int size) {
    int change = 0;
    for (int v = 0; v < mesh.size(); v++) {
      if (mesh.isUnmet(v)) {
        progress.report((double) v / mesh.size(), "Improving pieces of " + size + " vertices");
        progress.checkCancelled();
        region.open(mesh.halfEdgeAt(v, random));
        region.grow(size / 2 + random.nextInt(size / 2 + 1), TRIES);
        change += region.fill(NOISE_BITS);
      }
    }
    return change;
  }
}
