package dct.core.geometry;

import dct.core.Decimals;
import java.util.Locale;

/**
 * Why points are not a simple polygon, or not usable sites: the first defect found.
 *
 * @param kind what is wrong
 * @param first a vertex; for {@link Kind#CROSSING} and {@link Kind#OVERLAP} the edge from this
 *     vertex to the next
 * @param second the other vertex, or the other edge, as above; equal to {@code first} where the
 *     defect has no second part
 * @param x where to look: the crossing point (rounded), or the vertex
 * @param y the y-coordinate of that place
 * @param count the number of vertices, so that the edge after the last one can be named
 */
public record Defect(Kind kind, int first, int second, double x, double y, int count) {

  /** The ways in which points can fail. */
  public enum Kind {
    /** Fewer than three vertices. */
    TOO_FEW,
    /** All vertices lie on one line. */
    COLLINEAR,
    /** Fewer than three sites. */
    FEW_SITES,
    /** All sites lie on one line. */
    SITES_ON_ONE_LINE,
    /** Two vertices coincide. */
    DUPLICATE,
    /** The boundary turns back along itself at a vertex. */
    SPIKE,
    /** A vertex lies inside an edge that is not its own. */
    TOUCH,
    /** Two edges cross in their interiors. */
    CROSSING,
    /** Two edges share a whole segment. */
    OVERLAP
  }

  /** What keeps these sites from having a triangle, {@link Kind#FEW_SITES} or on one line. */
  public static Defect ofSites(Kind kind, Points sites) {
    boolean any = sites.size() > 0;
    return new Defect(kind, 0, 0, any ? sites.x(0) : 0, any ? sites.y(0) : 0, sites.size());
  }

  /** One sentence for a person: what is wrong, where, and what would mend it. */
  public String message() {
    return switch (kind) {
      case TOO_FEW -> count + (count == 1 ? " vertex" : " vertices") + "; three or more are needed";
      case COLLINEAR -> "all vertices lie on one line; move at least one off it";
      case FEW_SITES -> count + (count == 1 ? " site" : " sites") + "; three or more are needed";
      case SITES_ON_ONE_LINE -> "all sites lie on one line; move at least one off it";
      case DUPLICATE ->
          String.format(
              Locale.ROOT,
              "vertices v%d and v%d are both at %s; remove one of them",
              first,
              second,
              place());
      case SPIKE ->
          String.format(
              Locale.ROOT,
              "the boundary turns back along itself at vertex v%d, %s; move or remove that vertex",
              first,
              place());
      case TOUCH ->
          String.format(
              Locale.ROOT,
              "vertex v%d touches edge %s at %s; move it off the edge",
              first,
              edge(second),
              place());
      case CROSSING ->
          String.format(
              Locale.ROOT,
              "edges %s and %s cross at %s; move a vertex of one of them",
              edge(first),
              edge(second),
              place());
      case OVERLAP ->
          String.format(
              Locale.ROOT,
              "edges %s and %s overlap at %s; move a vertex of one of them",
              edge(first),
              edge(second),
              place());
    };
  }

  private String place() {
    return "(" + Decimals.format(x) + ", " + Decimals.format(y) + ")";
  }

  private String edge(int v) {
    return "v" + v + "–v" + (v + 1) % count;
  }
}
