package dct.core.degree.best;

import dct.core.Progress;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.Preference;
import dct.core.degree.Preferred;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.RegionBounds;
import dct.core.geometry.Region;
import dct.core.triangulate.Triangulation;

/** A triangulation of a region with as few unmet vertices as can be found. */
public final class RegionOptimizer {
  private RegionOptimizer() {}

  /** The best triangulation found. */
  public static Optimum optimize(
      Region region, Triangulation start, ParityGoal goal, SearchLimits limits, Progress progress) {
    Triangulation flipped = ScanFlip.run(start, progress).after();
    return Optimum.of(flipped, goal, RegionBounds.of(region, goal));
  }

  /** The same, and of several equally good ones that were found the most preferred. */
  public static Preferred optimize(
      Region region,
      Triangulation start,
      ParityGoal goal,
      SearchLimits limits,
      Preference preference,
      Progress progress) {
    Optimum best = optimize(region, start, goal, limits, progress);
    return PreferredRegions.improve(best, preference, limits, new dct.core.Deadline(progress, 1));
  }
}
