package dct.io.format.drawing;

/** The map (x, y) → (ax + cy + e, bx + dy + f); the identity keeps every number as it is. */
record Affine(double a, double b, double c, double d, double e, double f) {
  static final Affine IDENTITY = new Affine(1, 0, 0, 1, 0, 0);

  /** The map that applies another one first. */
  Affine of(Affine first) {
    if (isIdentity()) {
      return first;
    }
    return first.isIdentity()
        ? this
        : new Affine(
            a * first.a + c * first.b,
            b * first.a + d * first.b,
            a * first.c + c * first.d,
            b * first.c + d * first.d,
            x(first.e, first.f),
            y(first.e, first.f));
  }

  /** The map that this one undoes, if it has neither a rotation nor a zero. */
  Affine inverse() {
    return new Affine(1 / a, 0, 0, 1 / d, -e / a, -f / d);
  }

  boolean isIdentity() {
    return equals(IDENTITY);
  }

  /** The x of the image of a point. */
  double x(double px, double py) {
    return isIdentity() ? px : a * px + c * py + e;
  }

  /** The y of the image of a point. */
  double y(double px, double py) {
    return isIdentity() ? py : b * px + d * py + f;
  }

  /** The largest factor by which a side along an axis grows. */
  double scale() {
    return Math.max(Math.hypot(a, b), Math.hypot(c, d));
  }
}
