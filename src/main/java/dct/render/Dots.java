package dct.render;

/** How large the dots at vertices and the rings round them are, in pixels. */
final class Dots {
  private static final double CROWDED = 1.5;
  private static final double RING_GAP = 4;

  /** Half the side of a square, for each unit of the radius of a disc that looks as large. */
  static final double SQUARE = 0.9;

  private Dots() {}

  /** Whether dots of this radius are so many that nothing beside them can be told apart. */
  static boolean areCrowded(double radius) {
    return radius <= CROWDED;
  }

  /** The radius of the ring round a dot whose wish is not granted. */
  static double ringRadius(double radius) {
    return radius + RING_GAP;
  }
}
