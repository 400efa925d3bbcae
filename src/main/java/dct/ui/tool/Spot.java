package dct.ui.tool;

import dct.render.Viewport;

/**
 * A place that the mouse points at.
 *
 * @param screenX its x on the canvas, in pixels
 * @param screenY its y on the canvas, in pixels
 * @param x its x in the model, rounded as {@link #rounded} says
 * @param y its y in the model, rounded likewise
 * @param clicks how many clicks this one is: 2 if it is the second of a double click
 * @param shift whether the Shift key is down
 */
public record Spot(double screenX, double screenY, double x, double y, int clicks, boolean shift) {
  /** What a coordinate that was typed or drawn may have beyond the decimals of a step. */
  private static final int SPARE_DECIMALS = 6;

  /** The place at this pixel, for a single click without Shift. */
  public static Spot at(Viewport view, double screenX, double screenY) {
    double x = rounded(view, view.modelX(screenX));
    double y = rounded(view, view.modelY(screenY));
    return new Spot(screenX, screenY, x, y, 1, false);
  }

  /** The same place as so many clicks. */
  public Spot clicked(int times) {
    return new Spot(screenX, screenY, x, y, times, shift);
  }

  /** The same place with the Shift key down or up. */
  public Spot withShift(boolean down) {
    return new Spot(screenX, screenY, x, y, clicks, down);
  }

  /** How far another place is on the screen, in pixels. */
  public double distance(Spot other) {
    return Math.hypot(screenX - other.screenX, screenY - other.screenY);
  }

  /**
   * A model coordinate rounded to the greatest power of ten that is not coarser than a pixel: to
   * integers in actual size, to tenths when zoomed in by two to ten.
   */
  public static double rounded(Viewport view, double value) {
    return rounded(value, decimals(view));
  }

  /**
   * By how much an arrow key moves things: 1 while a unit has between a tenth of a pixel and ten
   * pixels, and the power of ten that has as many in other scales.
   */
  public static double step(Viewport view) {
    return Math.pow(10, -stepDecimals(view));
  }

  private static int stepDecimals(Viewport view) {
    double log = Math.log10(view.scale());
    return (int) (log + Math.copySign(1e-9, log)); // towards 1
  }

  /** A coordinate moved by a step, or some; what rounding would add to its digits is left out. */
  public static double stepped(Viewport view, double value, double by) {
    double sum = value + by;
    double tidy = rounded(sum, Math.max(0, stepDecimals(view)) + SPARE_DECIMALS);
    return Math.abs(tidy - sum) <= 4 * Math.ulp(Math.max(Math.abs(value), Math.abs(by)))
        ? tidy
        : sum;
  }

  /** The decimals of a coordinate that tell pixels apart; fewer than none for tens, hundreds, …. */
  static int decimals(Viewport view) {
    return (int) Math.ceil(Math.log10(view.scale()) - 1e-9);
  }

  /** A coordinate rounded to so many decimals. */
  static double rounded(double value, int decimals) {
    double power = Math.pow(10, Math.abs(decimals));
    double result =
        decimals >= 0 ? Math.rint(value * power) / power : Math.rint(value / power) * power;
    return Double.isFinite(result) ? result : value;
  }
}
