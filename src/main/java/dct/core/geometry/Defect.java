package dct.core.geometry;

import dct.core.Decimals;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.function.DoubleFunction;

/**
 * Why points are not a simple polygon, rings not a region, or points not usable sites: the first
 * defect found.
 *
 * @param kind what is wrong
 * @param first a vertex, or one end of an edge
 * @param firstEnd the other end of that edge; {@code first} where it is a vertex
 * @param second the other vertex, or one end of the other edge; {@code first} where the defect has
 *     no second part
 * @param secondEnd the other end of that edge; {@code second} where it is a vertex
 * @param x where to look: the crossing point (rounded), or the vertex
 * @param y the y-coordinate of that place
 * @param count the number of vertices
 */
public record Defect(
    Kind kind, int first, int firstEnd, int second, int secondEnd, double x, double y, int count) {
  private static final MathContext NINE_DIGITS = new MathContext(9, RoundingMode.HALF_EVEN);

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
    OVERLAP,
    /** A hole has fewer than three vertices. */
    SMALL_HOLE,
    /** A hole lies outside of the outer ring, or inside another hole. */
    STRAY_HOLE,
    /** A site lies outside of the region. */
    STRAY_SITE,
    /** A fixed edge runs outside of the region. */
    STRAY_EDGE
  }

  /**
   * Of a closed chain through all vertices in their order, whose edges are known by their first
   * vertices.
   */
  public Defect(Kind kind, int first, int second, double x, double y, int count) {
    this(
        kind,
        first,
        kind == Kind.CROSSING || kind == Kind.OVERLAP ? (first + 1) % count : first,
        second,
        kind == Kind.CROSSING || kind == Kind.OVERLAP || kind == Kind.TOUCH
            ? (second + 1) % count
            : second,
        x,
        y,
        count);
  }

  /** What keeps these sites from having a triangle, {@link Kind#FEW_SITES} or on one line. */
  public static Defect ofSites(Kind kind, Points sites) {
    boolean any = sites.size() > 0;
    return new Defect(kind, 0, 0, any ? sites.x(0) : 0, any ? sites.y(0) : 0, sites.size());
  }

  /** One sentence for a person: what is wrong, where, and what would mend it. */
  public String message() {
    String at =
        switch (kind) {
          case TOUCH -> " at " + place(Decimals::format);
          case SPIKE, STRAY_HOLE, STRAY_SITE -> ", " + place(Decimals::format);
          case CROSSING, OVERLAP -> " at " + place(Defect::computed);
          default -> "";
        };
    return fact() + at + "; " + cure();
  }

  /** What is wrong, without what would mend it; crossings and the like without the place. */
  public String fact() {
    return switch (kind) {
      case TOO_FEW -> count + (count == 1 ? " vertex" : " vertices");
      case COLLINEAR -> "all vertices lie on one line";
      case FEW_SITES -> count + (count == 1 ? " site" : " sites");
      case SITES_ON_ONE_LINE -> "all sites lie on one line";
      case DUPLICATE ->
          "vertices v" + first + " and v" + second + " are both at " + place(Decimals::format);
      case SPIKE -> "the boundary turns back along itself at vertex v" + first;
      case TOUCH -> "vertex v" + first + " touches edge " + edge(second, secondEnd);
      case CROSSING -> edges() + " cross";
      case OVERLAP -> edges() + " overlap";
      case SMALL_HOLE -> "the hole at vertex v" + first + " has fewer than three vertices";
      case STRAY_HOLE ->
          first == second
              ? "vertex v" + first + " of a hole lies outside of the outer ring"
              : "vertex v" + first + " of a hole lies in the hole of v" + second;
      case STRAY_SITE -> "site v" + first + " lies outside of the region";
      case STRAY_EDGE -> "the fixed edge " + edge(first, firstEnd) + " leaves the region";
    };
  }

  /** What would mend it. */
  public String cure() {
    return switch (kind) {
      case TOO_FEW, FEW_SITES -> "three or more are needed";
      case COLLINEAR, SITES_ON_ONE_LINE -> "move at least one off it";
      case DUPLICATE -> "remove one of them";
      case SPIKE -> "move or remove that vertex";
      case TOUCH -> "move it off the edge";
      case CROSSING, OVERLAP -> "move a vertex of one of them";
      case SMALL_HOLE -> "remove it, or add vertices";
      case STRAY_HOLE -> "move the hole into the region, or make it a region of its own";
      case STRAY_SITE -> "move it inside, or remove it";
      case STRAY_EDGE -> "remove it, or join other vertices";
    };
  }

  private String edges() {
    return "edges " + edge(first, firstEnd) + " and " + edge(second, secondEnd);
  }

  private String place(DoubleFunction<String> format) {
    return "(" + format.apply(x) + ", " + format.apply(y) + ")";
  }

  /** A computed coordinate, rounded to nine digits. */
  private static String computed(double value) {
    return Decimals.format(new BigDecimal(value).round(NINE_DIGITS).doubleValue());
  }

  private static String edge(int u, int v) {
    return "v" + u + "–v" + v;
  }
}
