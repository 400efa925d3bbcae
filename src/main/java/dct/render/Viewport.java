package dct.render;

import dct.core.geometry.Box;
import java.util.Locale;
import java.util.Objects;

/**
 * Maps model coordinates, those of the file, to the screen and back; immutable.
 *
 * <p>The screen's y runs down. Only this class knows whether the model's does too: it does for what
 * is drawn with the mouse (the thesis's canvas); imported data mostly has y upwards.
 */
public final class Viewport {
  /** One model unit is one pixel, the origin is the upper left corner, y runs down. */
  public static final Viewport IDENTITY = new Viewport(1, 0, 0, 0, 0, false);

  private static final double SMALLEST_HALF = 1e-290;
  private static final double LARGEST_SCALE = 1e290;

  // The model point (x, y) is at (atX, atY) on the screen. Subtracting it before scaling keeps the
  // digits of data that lies far from the origin.
  private final double scale;
  private final double x;
  private final double y;
  private final double atX;
  private final double atY;
  private final boolean yUp;

  private Viewport(double scale, double x, double y, double atX, double atY, boolean yUp) {
    this.scale = scale;
    this.x = x;
    this.y = y;
    this.atX = atX;
    this.atY = atY;
    this.yUp = yUp;
  }

  /**
   * The viewport that shows the box as large as it fits, in the middle of a screen. A box without
   * size, a single point, is shown in actual size.
   *
   * @param margin pixels left free on each side
   */
  public static Viewport fit(Box box, double width, double height, double margin, boolean yUp) {
    double roomX = Math.max(width / 2 - margin, 1);
    double roomY = Math.max(height / 2 - margin, 1);
    double fitting =
        Math.min(
            roomX / Math.max(box.halfWidth(), SMALLEST_HALF),
            roomY / Math.max(box.halfHeight(), SMALLEST_HALF));
    boolean point = box.halfWidth() == 0 && box.halfHeight() == 0;
    double scale = point ? 1 : fitting;
    double x = box.centerX();
    double y = box.centerY();
    double right = scale * rounding(box.minX(), x, box.maxX());
    double down = scale * rounding(box.minY(), y, box.maxY());
    double atY = height / 2 + (yUp ? down : -down);
    return new Viewport(scale, x, y, width / 2 - right, atY, yUp);
  }

  /** How far the middle of a range lies behind its rounded value: half an ulp, or nothing. */
  private static double rounding(double min, double middle, double max) {
    return (min - middle) / 2 + (max - middle) / 2;
  }

  /** Pixels per model unit. */
  public double scale() {
    return scale;
  }

  /** Whether the model's y runs up the screen. */
  public boolean yUp() {
    return yUp;
  }

  /** The screen's x of a model x. */
  public double screenX(double modelX) {
    return atX + scale * (modelX - x);
  }

  /** The screen's y of a model y. */
  public double screenY(double modelY) {
    return atY + (yUp ? scale * (y - modelY) : scale * (modelY - y));
  }

  /** Where a box of the model is on the screen. */
  Box screenBox(Box model) {
    double oneY = screenY(model.minY());
    double otherY = screenY(model.maxY());
    return new Box(
        screenX(model.minX()),
        Math.min(oneY, otherY),
        screenX(model.maxX()),
        Math.max(oneY, otherY));
  }

  /** The model's x of a screen x. */
  public double modelX(double screenX) {
    return x + (screenX - atX) / scale;
  }

  /** The model's y of a screen y. */
  public double modelY(double screenY) {
    return y + (yUp ? (atY - screenY) / scale : (screenY - atY) / scale);
  }

  /**
   * This viewport scaled by the factor, with the model point under this place of the screen kept
   * there. Scales that numbers cannot hold are not reached.
   */
  public Viewport zoomed(double factor, double screenX, double screenY) {
    double target = scale * factor;
    if (!(target > 1 / LARGEST_SCALE && target < LARGEST_SCALE)) {
      return this;
    }
    double nearX = modelX(screenX);
    double nearY = modelY(screenY);
    // Numbers are sparse in what is zoomed very far: the nearest one need not be at this place.
    double atNearX = screenX + factor * (screenX(nearX) - screenX);
    double atNearY = screenY + factor * (screenY(nearY) - screenY);
    return new Viewport(target, nearX, nearY, atNearX, atNearY, yUp);
  }

  /** This viewport with everything on the screen moved by so many pixels. */
  public Viewport panned(double dx, double dy) {
    return new Viewport(scale, x, y, atX + dx, atY + dy, yUp);
  }

  /** This viewport with a model point moved to this place of the screen. */
  public Viewport showing(double modelX, double modelY, double screenX, double screenY) {
    return new Viewport(scale, modelX, modelY, screenX, screenY, yUp);
  }

  /** This viewport with y the other way, and this place of the screen kept where it is. */
  public Viewport flipped(double screenX, double screenY) {
    double nearX = modelX(screenX);
    double nearY = modelY(screenY);
    double atNearY = 2 * screenY - screenY(nearY);
    return new Viewport(scale, nearX, nearY, screenX(nearX), atNearY, !yUp);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Viewport that
        && scale == that.scale
        && x == that.x
        && y == that.y
        && atX == that.atX
        && atY == that.atY
        && yUp == that.yUp;
  }

  @Override
  public int hashCode() {
    return Objects.hash(scale, x, y, atX, atY, yUp);
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "(%s, %s) at (%s, %s), scale %s, y %s",
        x,
        y,
        atX,
        atY,
        scale,
        yUp ? "up" : "down");
  }
}
