package dct.experiment.generate;

import dct.core.SeededRandom;
import dct.core.geometry.Points;

/**
 * Seeded random sites with integer coordinates, all different: {@link SiteShape#UNIFORM}, and none
 * where none are asked for.
 *
 * <p>The same number and seed give the same sites on every machine and JDK; a smaller number on the
 * same canvas gives the first of them.
 */
public final class RandomSites {
  /** The largest number of sites that can be asked for. */
  public static final int MOST = SiteShape.MOST;

  private RandomSites() {}

  /**
   * Draws n sites uniformly, each place at most once, in O(n).
   *
   * @throws IllegalArgumentException if n is negative or above {@link #MOST}
   */
  public static Points uniform(int n, long seed) {
    if (n < 0 || n > MOST) {
      throw new IllegalArgumentException(n + " sites");
    }
    Area area = SiteShape.UNIFORM.areaFor(n);
    return Places.distinct(n, area.grid(), new SeededRandom(seed)).points();
  }
}
