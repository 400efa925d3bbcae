package dct.ui.tool;

import dct.render.Viewport;

/**
 * A place that the mouse points at.
 *
 * @param screenX its x on the canvas, in pixels
 * @param screenY its y on the canvas, in pixels
 * @param x its x in the model, rounded as {@link #rounded} says
 * @param y its y in the model, rounded likewise
 */
public record Spot(double screenX, double screenY, double x, double y) {

  /** The place at this pixel. */
  public static Spot at(Viewport view, double screenX, double screenY) {
    return new Spot(
        screenX, screenY, rounded(view, view.modelX(screenX)), rounded(view, view.modelY(screenY)));
  }

  /**
   * A model coordinate rounded to the greatest power of ten that is not coarser than a pixel: to
   * integers in actual size, to tenths when zoomed in by two to ten.
   */
  public static double rounded(Viewport view, double value) {
    int decimals = (int) Math.ceil(Math.log10(view.scale()) - 1e-9);
    double power = Math.pow(10, Math.abs(decimals));
    double result =
        decimals >= 0 ? Math.rint(value * power) / power : Math.rint(value / power) * power;
    return Double.isFinite(result) ? result : value;
  }
}
