package dct.core.degree;

import dct.core.dcel.Dcel;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import dct.core.triangulate.Triangulation;
import java.util.Optional;

/**
 * The exchange of the diagonals of a strictly convex quadrilateral, named by its corners, so that
 * it can be carried out in any triangulation of the same points that has the two triangles.
 *
 * <pre>
 *       x                x
 *      /|\              / \
 *     / | \            /   \
 *    u--+--v   --->   u     v      the edge u v is replaced by the edge x y
 *     \ | /            \   /
 *      \|/              \ /
 *       y                y
 * </pre>
 *
 * <p>A flip changes the parity of its four corners and of no other vertex. All decisions are exact
 * and take constant time, given the edge.
 *
 * @param u one end of the edge that is removed
 * @param v its other end
 * @param x one end of the edge that is made
 * @param y its other end
 */
public record Flip(int u, int v, int x, int y) {

  /** Why an edge cannot be flipped. */
  public enum Obstacle {
    /** It has a triangle on one side only, or on none. */
    BOUNDARY("is on the boundary"),
    /** Its two triangles form no strictly convex quadrilateral. */
    NOT_CONVEX("has two triangles that form no strictly convex quadrilateral");

    private final String clause;

    Obstacle(String clause) {
      this.clause = clause;
    }

    /** What is to be said of the edge, for a person: {@code is on the boundary}. */
    public String clause() {
      return clause;
    }
  }

  /** The flip of an edge of a triangulation; empty where there is an {@link #obstacle}. */
  public static Optional<Flip> at(Triangulation triangulation, int edge) {
    return obstacle(triangulation, edge).isEmpty()
        ? Optional.of(of(triangulation.dcel(), 2 * edge))
        : Optional.empty();
  }

  /** Why an edge of a triangulation cannot be flipped; empty if it can. */
  public static Optional<Obstacle> obstacle(Triangulation triangulation, int edge) {
    return obstacle(triangulation.points(), triangulation.dcel(), 2 * edge);
  }

  static Optional<Obstacle> obstacle(Points points, Dcel dcel, int e) {
    if (!dcel.canFlip(e)) {
      return Optional.of(Obstacle.BOUNDARY);
    }
    return of(dcel, e).isStrictlyConvex(points)
        ? Optional.empty()
        : Optional.of(Obstacle.NOT_CONVEX);
  }

  /** The exchange of the diagonals at a half-edge with a triangle on each side. */
  static Flip of(Dcel dcel, int e) {
    return new Flip(dcel.origin(e), dcel.target(e), apex(dcel, e), apex(dcel, e ^ 1));
  }

  private static int apex(Dcel dcel, int e) {
    return dcel.origin(dcel.prev(e));
  }

  /** Whether x and y, on the two sides of u v, have u and v strictly on the two sides of x y. */
  private boolean isStrictlyConvex(Points points) {
    return points.orient(y, x, u) * points.orient(y, x, v) < 0;
  }

  /** The flip that takes this one back. */
  public Flip inverse() {
    return new Flip(x, y, u, v);
  }

  /** Whether it is the same flip, with the ends of the edges in any order. */
  public boolean isSameAs(Flip that) {
    return isPair(u, v, that.u, that.v) && isPair(x, y, that.x, that.y);
  }

  private static boolean isPair(int a, int b, int c, int d) {
    return (a == c && b == d) || (a == d && b == c);
  }

  /**
   * By how many the number of even vertices grows if this flip is carried out in a triangulation:
   * −4, −2, 0, 2 or 4.
   */
  public int evenGain(Triangulation triangulation) {
    return gain(triangulation, Wish.EVEN, u)
        + gain(triangulation, Wish.EVEN, v)
        + gain(triangulation, Wish.EVEN, x)
        + gain(triangulation, Wish.EVEN, y);
  }

  /** By how many the number of granted wishes grows if this flip is carried out: −4 … 4. */
  public int gain(Triangulation triangulation, ParityGoal goal) {
    return gain(triangulation, goal.wish(u), u)
        + gain(triangulation, goal.wish(v), v)
        + gain(triangulation, goal.wish(x), x)
        + gain(triangulation, goal.wish(y), y);
  }

  private static int gain(Triangulation triangulation, Wish wish, int corner) {
    boolean before = wish.isGrantedBy(triangulation.degree(corner));
    boolean after = wish.isGrantedBy(triangulation.degree(corner) + 1);
    return (after ? 1 : 0) - (before ? 1 : 0);
  }

  /** For a person: {@code v0–v2 becomes v1–v3}. */
  @Override
  public String toString() {
    return removed() + " becomes " + made();
  }

  /** The edge that is removed, for a person: {@code v0–v2}. */
  public String removed() {
    return "v" + u + "–v" + v;
  }

  /** The edge that is made, for a person. */
  public String made() {
    return "v" + x + "–v" + y;
  }
}
