package dct.core.geometry;

/**
 * A rectangle with sides along the axes.
 *
 * @param minX the least x
 * @param minY the least y
 * @param maxX the greatest x
 * @param maxY the greatest y
 */
public record Box(double minX, double minY, double maxX, double maxY) {

  /**
   * The smallest box round these points, in linear time.
   *
   * @throws IllegalArgumentException if there are no points
   */
  public static Box of(Points points) {
    if (points.size() == 0) {
      throw new IllegalArgumentException("no points");
    }
    Box first = new Box(points.x(0), points.y(0), points.x(0), points.y(0));
    return first.around(points, 1, points.size());
  }

  /**
   * The smallest box round all of these points but one, in linear time.
   *
   * @throws IllegalArgumentException if there are no others
   */
  public static Box ofOthers(Points points, int without) {
    if (points.size() < 2) {
      throw new IllegalArgumentException("no other points");
    }
    int other = without == 0 ? 1 : 0;
    Box first = new Box(points.x(other), points.y(other), points.x(other), points.y(other));
    return first.around(points, 0, without).around(points, without + 1, points.size());
  }

  /** The smallest box round this one and the points first … end − 1. */
  private Box around(Points points, int first, int end) {
    double left = minX;
    double right = maxX;
    double low = minY;
    double high = maxY;
    for (int i = first; i < end; i++) {
      left = Math.min(left, points.x(i));
      right = Math.max(right, points.x(i));
      low = Math.min(low, points.y(i));
      high = Math.max(high, points.y(i));
    }
    return new Box(left, low, right, high);
  }

  /** The smallest box round this one and a point. */
  public Box around(double x, double y) {
    return new Box(Math.min(minX, x), Math.min(minY, y), Math.max(maxX, x), Math.max(maxY, y));
  }

  /** Half the width; unlike the width it cannot overflow. */
  public double halfWidth() {
    return maxX / 2 - minX / 2;
  }

  /** Half the height; unlike the height it cannot overflow. */
  public double halfHeight() {
    return maxY / 2 - minY / 2;
  }

  /** The x-coordinate of the centre. */
  public double centerX() {
    return minX / 2 + maxX / 2;
  }

  /** The y-coordinate of the centre. */
  public double centerY() {
    return minY / 2 + maxY / 2;
  }

  /** Whether a segment with these ends can meet this box; true for every one that does. */
  public boolean mayMeet(double x1, double y1, double x2, double y2) {
    return Math.max(x1, x2) >= minX
        && Math.min(x1, x2) <= maxX
        && Math.max(y1, y2) >= minY
        && Math.min(y1, y2) <= maxY;
  }

  /** Whether the boxes have a point in common, their borders included. */
  public boolean meets(Box other) {
    return mayMeet(other.minX, other.minY, other.maxX, other.maxY);
  }

  /** Whether this box holds the point, its border included. */
  public boolean holds(double x, double y) {
    return x >= minX && x <= maxX && y >= minY && y <= maxY;
  }

  /** Whether a point of this box is on one of its sides. */
  public boolean isOnBorder(double x, double y) {
    return x == minX || x == maxX || y == minY || y == maxY;
  }

  /** Whether the other box lies in this one and is not small in it: a quarter of a side or more. */
  public boolean suits(Box other) {
    return holds(other.minX, other.minY)
        && holds(other.maxX, other.maxY)
        && (4 * other.halfWidth() >= halfWidth() || 4 * other.halfHeight() >= halfHeight());
  }

  /** This box with every side moved outwards. */
  public Box grown(double by) {
    return new Box(minX - by, minY - by, maxX + by, maxY + by);
  }
}
