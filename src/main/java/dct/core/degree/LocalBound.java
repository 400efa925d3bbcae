package dct.core.degree;

import java.util.BitSet;
import java.util.Collection;

/**
 * That some sites have at least so many unmet ones among them in every triangulation.
 *
 * @param sites all sites in some open convex region; not to be changed
 * @param unmet the number
 */
public record LocalBound(BitSet sites, int unmet) {

  /** The sum over windows that have no site in common. */
  public static int sum(Collection<LocalBound> windows) {
    return windows.stream().mapToInt(LocalBound::unmet).sum();
  }
}
