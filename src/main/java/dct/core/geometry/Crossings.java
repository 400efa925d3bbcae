package dct.core.geometry;

import dct.core.Progress;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;

/**
 * Where segments cross each other or a level line: computed exactly at every scale of the
 * coordinates, then rounded. A crossing therefore never lies outside the boxes of its segments.
 *
 * <p>In decimal arithmetic of any length, some microseconds a crossing for ordinary coordinates.
 */
public final class Crossings {
  /** Every pair of edges is looked at, also with each move of a drag. */
  static final int MOST_VERTICES = 400;

  private Crossings() {}

  /**
   * All crossings of the edges of these rings and the fixed ones, in O(n²); none are looked for if
   * there are more than {@value #MOST_VERTICES} vertices and fixed edges.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static List<Defect> of(Rings rings, Progress progress) {
    List<Defect> crossings = new ArrayList<>();
    Points points = rings.points();
    int edges = points.size() + rings.fixedCount();
    for (int one = 0; one < edges && edges <= MOST_VERTICES; one++) {
      progress.checkCancelled();
      for (int other = one + 1; other < edges && isEdge(rings, one); other++) {
        if (isEdge(rings, other)) {
          add(
              points,
              rings.from(one),
              rings.to(one),
              rings.from(other),
              rings.to(other),
              crossings);
        }
      }
    }
    return crossings;
  }

  /** There is none behind the number of a site. */
  private static boolean isEdge(Rings rings, int edge) {
    return edge >= rings.points().size() || rings.isOnRing(edge);
  }

  private static void add(Points points, int a, int b, int c, int d, List<Defect> crossings) {
    if (areCrossing(points, a, b, c, d)) {
      crossings.add(defect(points, a, b, c, d));
    }
  }

  /** Whether the segments ab and cd cross in their interiors. */
  private static boolean areCrossing(Points points, int a, int b, int c, int d) {
    return points.orient(a, b, c) * points.orient(a, b, d) < 0
        && points.orient(c, d, a) * points.orient(c, d, b) < 0;
  }

  /** The crossing of the edges ab and cd, which do cross. */
  static Defect defect(Points points, int a, int b, int c, int d) {
    BigDecimal top = cross(points, a, c, c, d);
    BigDecimal bottom = cross(points, a, b, c, d);
    double x = between(points.x(a), points.x(b), top, bottom);
    double y = between(points.y(a), points.y(b), top, bottom);
    return new Defect(Defect.Kind.CROSSING, a, b, c, d, x, y, points.size());
  }

  /** The cross product of the vectors from a to b and from c to d. */
  private static BigDecimal cross(Points p, int a, int b, int c, int d) {
    BigDecimal ux = BigPredicates.minus(p.x(b), p.x(a));
    BigDecimal uy = BigPredicates.minus(p.y(b), p.y(a));
    BigDecimal vx = BigPredicates.minus(p.x(d), p.x(c));
    BigDecimal vy = BigPredicates.minus(p.y(d), p.y(c));
    return BigPredicates.cross(ux, uy, vx, vy);
  }

  /** from + (to − from) · top / bottom, divided last so that only the result is rounded. */
  private static double between(double from, double to, BigDecimal top, BigDecimal bottom) {
    return weighted(from, to, top, bottom).divide(bottom, MathContext.DECIMAL128).doubleValue();
  }

  private static BigDecimal weighted(double from, double to, BigDecimal top, BigDecimal bottom) {
    BigDecimal step = BigPredicates.minus(to, from).multiply(top);
    return new BigDecimal(from).multiply(bottom).add(step);
  }

  /**
   * The x-coordinate at which the segment ab, which is not level, reaches height y: the largest
   * double that is not right of it if {@code down}, else the smallest that is not left of it.
   */
  public static double levelX(Points points, int a, int b, double y, boolean down) {
    int low = points.y(a) < points.y(b) ? a : b;
    int high = low == a ? b : a;
    BigDecimal top = BigPredicates.minus(y, points.y(low));
    BigDecimal height = BigPredicates.minus(points.y(high), points.y(low));
    BigDecimal exact = weighted(points.x(low), points.x(high), top, height); // times the height
    double x = exact.divide(height, MathContext.DECIMAL128).doubleValue() + 0.0;
    int side = new BigDecimal(x).multiply(height).compareTo(exact);
    if (side != 0 && side > 0 == down) {
      return (down ? Math.nextDown(x) : Math.nextUp(x)) + 0.0;
    }
    return x;
  }
}
