package dct.render;

/**
 * How a scene is drawn for the eye that will see it: on a screen, or on paper, where the same lines
 * and dots are finer beside letters of the same size. Lengths are in units of the drawing, in which
 * letters are as large as on a screen they are in pixels.
 *
 * @param lines the width of lines, for each pixel of it on a screen
 * @param thinnest the least width of a line
 * @param dots the radius of dots and rings, for each pixel of it on a screen
 * @param isTold whether lines are told apart by dashes and width, too, and not by colour alone
 */
record Gauge(double lines, double thinnest, double dots, boolean isTold) {
  /** What the screen shows. */
  static final Gauge SCREEN = new Gauge(1, 0, 1, false);

  private static final double HEAVY = 1.8;

  /** A line or shape that has this look on a screen. */
  Stroke of(Stroke stroke) {
    boolean dashed = stroke.dashed() || (isTold && stroke.ink() == Ink.PARTITION);
    boolean heavy = isTold && (stroke.ink() == Ink.FLIPPED || stroke.ink() == Ink.FIRST);
    double width = stroke.width() * lines * (heavy ? HEAVY : 1);
    return new Stroke(stroke.ink(), Math.max(thinnest, width), dashed);
  }

  /** The radius of the ring round a dot of this radius. */
  double ringRadius(double radius) {
    return Dots.ringRadius(radius / dots) * dots;
  }
}
