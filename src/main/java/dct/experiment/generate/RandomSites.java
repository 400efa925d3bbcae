package dct.experiment.generate;

import dct.core.geometry.Points;

/**
 * Seeded random sites with integer coordinates, all different.
 *
 * <p>The sites fall on the canvas of the thesis: 0 ≤ x &lt; {@value #WIDTH}, 0 ≤ y &lt; {@value
 * #HEIGHT}. Where so many are asked for that more than half of the places would be taken, both
 * sides of the canvas are doubled until that is no longer so. The same number and seed give the
 * same sites on every machine and JDK; a smaller number on the same canvas gives the first of them.
 */
public final class RandomSites {
  /** The width of the canvas. */
  public static final int WIDTH = 1000;

  /** The height of the canvas. */
  public static final int HEIGHT = 700;

  /** The largest number of sites that can be asked for. */
  public static final int MOST = 100_000_000;

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
    int scale = scale(n);
    Grid grid = new Area(WIDTH * scale, HEIGHT * scale, true).grid();
    return Places.distinct(n, grid, new SeededRandom(seed)).points();
  }

  private static int scale(int n) {
    int scale = 1;
    while (2L * n > (long) WIDTH * HEIGHT * scale * scale) {
      scale *= 2;
    }
    return scale;
  }
}
