package dct.problem.verify;

import dct.core.degree.LocalBound;
import java.util.BitSet;
import java.util.List;

/**
 * Some sites of which a file says that so many are unmet in every triangulation. They may be the
 * numbers of sites that there are not.
 */
public record ClaimedWindow(int unmet, List<Integer> sites) {

  /** Takes a copy of the list. */
  public ClaimedWindow {
    sites = List.copyOf(sites);
  }

  /**
   * The same for n sites.
   *
   * @throws FalseClaim if they are not among them, or the number is none that they can have
   */
  LocalBound among(int n) {
    BitSet set = new BitSet();
    for (int v : sites) {
      FalseClaim.unless(v >= 0 && v < n, "a window of the certificate has no site " + v);
      set.set(v);
    }
    FalseClaim.unless(
        unmet > 0 && unmet <= set.cardinality(),
        "a window of the certificate is said to have " + unmet + " unmet sites");
    return new LocalBound(set, unmet);
  }
}
