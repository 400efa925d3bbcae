package dct.ui.document;

import dct.core.geometry.Defect;
import dct.core.geometry.Points;
import java.util.ArrayList;
import java.util.List;

/** All places where edges of a small polygon cross, so that all of them can be marked. */
final class Crossings {
  /** Every pair of edges is looked at, also with each move of a drag. */
  static final int MOST_VERTICES = 400;

  private Crossings() {}

  /**
   * The crossings of the closed chain through these points, in O(n²); none are looked for if there
   * are more than {@value #MOST_VERTICES}.
   */
  static List<Defect> of(Points points) {
    List<Defect> crossings = new ArrayList<>();
    int n = points.size();
    if (n <= MOST_VERTICES) {
      for (int a = 0; a < n; a++) {
        for (int b = a + 2; b < n; b++) {
          if (cross(points, a, b)) {
            crossings.add(crossing(points, a, b));
          }
        }
      }
    }
    return crossings;
  }

  /** Whether the edges that leave vertices a and b cross in their interiors. */
  private static boolean cross(Points points, int a, int b) {
    int a2 = (a + 1) % points.size();
    int b2 = (b + 1) % points.size();
    return points.orient(a, a2, b) * points.orient(a, a2, b2) < 0
        && points.orient(b, b2, a) * points.orient(b, b2, a2) < 0;
  }

  private static Defect crossing(Points points, int a, int b) {
    int n = points.size();
    double ux = points.x((a + 1) % n) - points.x(a);
    double uy = points.y((a + 1) % n) - points.y(a);
    double vx = points.x((b + 1) % n) - points.x(b);
    double vy = points.y((b + 1) % n) - points.y(b);
    double wx = points.x(b) - points.x(a);
    double wy = points.y(b) - points.y(a);
    double t = (wx * vy - wy * vx) / (ux * vy - uy * vx);
    return new Defect(Defect.Kind.CROSSING, a, b, points.x(a) + t * ux, points.y(a) + t * uy, n);
  }
}
