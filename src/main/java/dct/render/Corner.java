package dct.render;

import dct.core.geometry.Box;
import dct.render.Pen.Anchor;

/** A corner of a picture. */
public enum Corner {
  UPPER_RIGHT(false, true),
  UPPER_LEFT(true, true),
  LOWER_RIGHT(false, false),
  LOWER_LEFT(true, false);

  private final boolean left;
  private final boolean upper;

  Corner(boolean left, boolean upper) {
    this.left = left;
    this.upper = upper;
  }

  /** The box of this size in this corner of a box. */
  Box box(Box whole, double width, double height) {
    double x = left ? whole.minX() : whole.maxX() - width;
    double y = upper ? whole.minY() : whole.maxY() - height;
    return new Box(x, y, x + width, y + height);
  }

  /** On which side texts in it begin. */
  Anchor anchor() {
    return left ? Anchor.START : Anchor.END;
  }
}
