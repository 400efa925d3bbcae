package dct.core.degree.bound;

import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Region;

/** Lower bounds for regions that take linear time. */
public final class RegionBounds {
  private RegionBounds() {}

  /** The best of them. */
  public static LowerBound of(Region region, ParityGoal goal) {
    return new LowerBound(0, "handshake lemma");
  }
}
