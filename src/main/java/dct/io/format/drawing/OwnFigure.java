package dct.io.format.drawing;

import java.util.Optional;
import java.util.Set;

/**
 * What is known of a file of Ipe that this program wrote as a figure, whether or not Ipe has saved
 * it since: the map from the points to the page, and which layers show them.
 *
 * <p>The outline of a polygon or region and the marks have the coordinates of the points and a
 * matrix that is this map; Ipe rounds the matrix when it saves. What somebody has moved on the page
 * has another matrix, and the place where it is now is mapped back.
 */
record OwnFigure(Affine toPage) {
  private static final String KEYWORD = "dct-points "; // and a matrix; IpePen writes it
  private static final String OUTLINE = "polygon";
  private static final String MARKS = "vertices";
  private static final String EDGES = "diagonals";
  private static final String FIXED = "fixed"; // the colour of fixed edges
  private static final Set<String> OTHERS =
      Set.of(EDGES, "partition", "flipped", "labels", "counts");
  private static final String INSIDE = "inside"; // the colour of the outline's ground
  private static final double ROUNDED = 1e-4; // of a factor
  private static final double NEAR = 0.01; // of a place, in points of the page

  /** What the element {@code info} says of it; nothing if another program wrote the file. */
  static Optional<OwnFigure> of(XmlText xml) {
    String keywords = xml.attribute("keywords");
    if (!keywords.startsWith(KEYWORD)) {
      return Optional.empty();
    }
    Affine map = Transform.ofIpe(xml, keywords.substring(KEYWORD.length()));
    boolean isPlain = map.a() != 0 && map.b() == 0 && map.c() == 0 && map.d() != 0;
    return isPlain ? Optional.of(new OwnFigure(map)) : Optional.empty();
  }

  /** Whether an object shows points, and is not drawn from them, as edges and words are. */
  boolean isInput(XmlText xml, String layer) {
    return switch (layer) {
      case OUTLINE -> xml.element().equals("path") && xml.attribute("fill").equals(INSIDE);
      case MARKS -> xml.element().equals("use");
      default -> !OTHERS.contains(layer) || isFixedEdge(xml, layer);
    };
  }

  /** Whether objects of this layer are the outline of a polygon or region. */
  static boolean isOutline(String layer) {
    return layer.equals(OUTLINE);
  }

  /** Whether objects of this layer are marks at the vertices. */
  static boolean isMarks(String layer) {
    return layer.equals(MARKS);
  }

  /** Whether an object is a fixed edge. */
  static boolean isFixedEdge(XmlText xml, String layer) {
    return layer.equals(EDGES)
        && xml.element().equals("path")
        && xml.attribute("stroke").equals(FIXED);
  }

  /** The map to the points from the coordinates of an object that this one maps to the page. */
  Affine toPoints(Affine matrix) {
    return isOwn(matrix) ? Affine.IDENTITY : toPage.inverse().of(matrix);
  }

  private boolean isOwn(Affine matrix) {
    return isRounded(matrix.a(), toPage.a())
        && isRounded(matrix.d(), toPage.d())
        && matrix.b() == 0
        && matrix.c() == 0
        && Math.abs(matrix.e() - toPage.e()) <= NEAR
        && Math.abs(matrix.f() - toPage.f()) <= NEAR;
  }

  private static boolean isRounded(double factor, double exact) {
    return Math.abs(factor - exact) <= ROUNDED * Math.abs(exact);
  }
}
