package dct.core.degree.region;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.degree.ParityGoal;
import dct.core.degree.Preference;
import dct.core.degree.SearchLimits;
import dct.core.geometry.SmallestAngle;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import java.util.stream.IntStream;

/**
 * Makes a triangulation more preferred and no less good: region by region, the most preferred of
 * all triangulations with the fewest unmet vertices is put in ({@link MeshRegion}).
 *
 * <p>A round visits the triangles, those of the smallest angles first where angles are preferred,
 * and grows a region round each. The search ends when a few rounds have changed nothing, or when so
 * many regions were solved; a region costs the same whatever the number of vertices. The same
 * triangulation, seed and effort give the same result, unless it is told to stop.
 */
public final class PreferredImprover {
  private static final int LEAST = 6; // vertices of a region
  private static final int MOST = 20;
  private static final int LARGE = 60; // of one round the triangle of the smallest angle
  private static final int IDLE_ROUNDS = 2;
  private static final int REGIONS_EACH = 6; // a triangle
  private static final int REGIONS = 20_000; // in all
  private static final int WORST_TRIES = 32; // at the triangle of the smallest angle
  private static final float FAIR = 2.75f; // cotangent of an angle of 20°, which is large enough
  private static final int SITE_TRIES = 3; // to grow by one vertex
  private static final int POLYGON_TRIES = 20; // most edges are the polygon's
  private static final int CHECK_EVERY = 64;

  private final Triangulation start;
  private final Progress progress;
  private final SearchMesh mesh;
  private final SeededRandom random;
  private final MeshRegion small;
  private final MeshRegion large;
  private final boolean isAngle;
  private long left; // regions

  private PreferredImprover(
      Triangulation start,
      ParityGoal goal,
      Preference preference,
      SearchLimits limits,
      Progress progress) {
    this.start = start;
    this.progress = progress;
    mesh = new SearchMesh(start, goal, 1, progress);
    random = new SeededRandom(limits.seed());
    small = region(preference, MOST);
    large = region(preference, LARGE);
    isAngle = preference.kind() == Preference.Kind.ANGLE;
    left =
        (long) (limits.effort() * Math.min(REGIONS, (long) REGIONS_EACH * start.triangleCount()));
  }

  private MeshRegion region(Preference preference, int most) {
    MeshRegion region = new MeshRegion(mesh, random, progress, most, 0, mesh.size());
    region.prefer(preference);
    return region;
  }

  /**
   * The most preferred triangulation found; the given one if none is better.
   *
   * @param progress a cancel ends the search with the best so far
   * @throws java.util.concurrent.CancellationException if cancelled before the search has begun
   */
  public static Triangulation improve(
      Triangulation start,
      ParityGoal goal,
      Preference preference,
      SearchLimits limits,
      Progress progress) {
    PreferredImprover improver = new PreferredImprover(start, goal, preference, limits, progress);
    return improver.run() ? MeshExport.triangulation(improver.mesh, start) : start;
  }

  private boolean run() {
    boolean changed = false;
    int idle = 0;
    while (idle < IDLE_ROUNDS && left > 0) {
      boolean helped = round();
      changed |= helped;
      idle = helped ? 0 : idle + 1;
    }
    return changed;
  }

  /** Solves a region round each triangle; whether one of them was better than before. */
  private boolean round() {
    int[] order = order();
    boolean helped = false;
    for (int tries = isAngle ? WORST_TRIES : 0; tries > 0 && order.length > 0; tries--) {
      helped |= solve(large, order[0], LARGE);
    }
    for (int i = 0; i < order.length && left > 0; i++) {
      helped |= solve(small, order[i], MOST);
    }
    return helped;
  }

  /** Solves a region round one triangle, if there is still time. */
  private boolean solve(MeshRegion region, int triangle, int most) {
    if (left > 0 && left % CHECK_EVERY == 0 && progress.isCancelled()) {
      left = 0;
    }
    if (left <= 0) {
      return false;
    }
    left--;
    region.open(4 * triangle + random.nextInt(3));
    int tries = start.domain() == Domain.SITES ? SITE_TRIES : POLYGON_TRIES;
    region.grow(LEAST + random.nextInt(most - LEAST + 1), tries);
    return region.fillPreferred();
  }

  /** The triangles; where angles are preferred those of small ones, the smallest first. */
  private int[] order() {
    IntStream all = IntStream.range(0, mesh.corner.length / 4);
    return isAngle
        ? all.mapToLong(t -> key(cotangent(4 * t), t))
            .filter(key -> key < key(FAIR, 0))
            .sorted()
            .mapToInt(key -> (int) key)
            .toArray()
        : all.toArray();
  }

  /** Ascends as the cotangent descends. */
  private static long key(float cotangent, int triangle) {
    int place = Integer.MAX_VALUE - Float.floatToRawIntBits(cotangent);
    return (long) place << Integer.SIZE | triangle;
  }

  private float cotangent(int e) {
    int u = mesh.corner[e];
    int v = mesh.corner[e + 1];
    int w = mesh.corner[e + 2];
    return (float)
        SmallestAngle.cotangent(mesh.x[u], mesh.y[u], mesh.x[v], mesh.y[v], mesh.x[w], mesh.y[w]);
  }
}
