package dct.core.geometry;

import dct.core.Progress;

/**
 * A simple polygon: its vertices in boundary order, checked once, here.
 *
 * <p>Vertices keep the numbers in which they were entered, clockwise or counter-clockwise. Inside,
 * the polygon is read counter-clockwise: {@link #vertex} maps a position on that walk, which starts
 * at vertex 0, to the vertex' own number. Straight (180°) vertices are ordinary vertices.
 */
public final class SimplePolygon {
  private final Points points;
  private final boolean clockwise;

  private SimplePolygon(Points points, boolean clockwise) {
    this.points = points;
    this.clockwise = clockwise;
  }

  /**
   * The polygon with these vertices, in O(n log n).
   *
   * @throws InvalidGeometryException if the boundary is not simple
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static SimplePolygon of(Points points, Progress progress) {
    SimplicityCheck.firstDefect(points, progress)
        .ifPresent(
            defect -> {
              throw new InvalidGeometryException(defect);
            });
    return new SimplePolygon(points, isClockwise(points));
  }

  /** The turn at the lowest vertex, or next to it where that one is straight, decides. */
  private static boolean isClockwise(Points points) {
    int n = points.size();
    int lowest = 0;
    for (int i = 1; i < n; i++) {
      if (points.yxLess(i, lowest)) {
        lowest = i;
      }
    }
    return points.orient((lowest + n - 1) % n, lowest, (lowest + 1) % n) < 0;
  }

  /** The vertices in the order entered. */
  public Points points() {
    return points;
  }

  /** The number of vertices, n. */
  public int size() {
    return points.size();
  }

  /** Whether the vertices were entered clockwise (in model coordinates, y upwards). */
  public boolean isClockwise() {
    return clockwise;
  }

  /** The number of the vertex at this position, 0 … n−1, of the counter-clockwise walk. */
  public int vertex(int position) {
    return clockwise && position != 0 ? points.size() - position : position;
  }

  /** The counter-clockwise walk as an array of vertex numbers. */
  public int[] walk() {
    int[] walk = new int[size()];
    for (int k = 0; k < walk.length; k++) {
      walk[k] = vertex(k);
    }
    return walk;
  }
}
