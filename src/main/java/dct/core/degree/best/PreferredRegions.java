package dct.core.degree.best;

import dct.core.Progress;
import dct.core.degree.Optimum;
import dct.core.degree.Preference;
import dct.core.degree.Preferred;
import dct.core.degree.SearchLimits;
import dct.core.degree.region.PreferredImprover;
import dct.core.triangulate.Triangulation;
import java.util.concurrent.CancellationException;

/** The last step of a search whose result is not proven to be the most preferred. */
final class PreferredRegions {

  private PreferredRegions() {}

  /**
   * What was found, made more preferred where that loses nothing ({@link PreferredImprover}).
   *
   * @param progress a cancel ends the search with the best so far
   */
  static Preferred improve(
      Optimum found, Preference preference, SearchLimits limits, Progress progress) {
    Triangulation start = found.triangulation();
    if (start.triangleCount() == 0 || progress.isCancelled()) {
      return Preferred.of(found, preference, false);
    }
    try {
      Triangulation better =
          PreferredImprover.improve(start, found.goal(), preference, limits, progress);
      return Preferred.of(found.of(better), preference, false);
    } catch (CancellationException e) {
      return Preferred.of(found, preference, false);
    }
  }
}
