package dct.experiment.generate;

import java.util.Locale;

/**
 * The rectangle 0 ≤ x &lt; width, 0 ≤ y &lt; height in which random points fall.
 *
 * <p>All generators work on the places of a {@link Grid} over it: the whole numbers, or the
 * multiples of a power of two so small that they stand for real numbers. On both, every geometric
 * test is exact in 64 bits.
 *
 * @param width the width, a whole number
 * @param height the height, a whole number
 * @param whole whether the coordinates are whole numbers
 */
public record Area(int width, int height, boolean whole) {
  /** The largest width and height. */
  public static final int LONGEST = 1 << 26;

  /** The canvas of the thesis, with a place for each pixel. */
  public static final Area CANVAS = new Area(1000, 700, true);

  private static final int BITS = 28;
  private static final int FINEST_BITS = 50;

  /**
   * An area.
   *
   * @throws CannotGenerateException if a side is not from 1 to {@link #LONGEST}
   */
  public Area {
    if (width < 1 || height < 1 || width > LONGEST || height > LONGEST) {
      throw new CannotGenerateException(
          String.format(
              Locale.ROOT,
              "an area of %d × %d cannot be; its sides are from 1 to %d",
              width,
              height,
              LONGEST));
    }
  }

  /** The area with both sides doubled. */
  Area doubled() {
    return new Area(2 * width, 2 * height, whole);
  }

  /** Whether there is an area with both sides doubled. */
  boolean canDouble() {
    return Math.max(width, height) <= LONGEST / 2;
  }

  /** This area with coordinates that are not confined to whole numbers. */
  public Area real() {
    return new Area(width, height, false);
  }

  /** The places of this area, fewer than 2^28 a side. */
  Grid grid() {
    return grid(BITS);
  }

  /** The places of this area, up to 2^50 a side where they need not be whole. */
  Grid finestGrid() {
    return grid(FINEST_BITS);
  }

  private Grid grid(int bits) {
    int fraction = whole ? 0 : bits - (Integer.SIZE - Integer.numberOfLeadingZeros(longest()));
    return new Grid((long) width << fraction, (long) height << fraction, fraction);
  }

  private int longest() {
    return Math.max(width, height);
  }

  @Override
  public String toString() {
    return width + " × " + height + (whole ? " whole places" : "");
  }
}
