package dct.io.format.lists;

import dct.core.geometry.Points;
import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.PointColumns;
import dct.io.format.Rows;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/**
 * Polygons of the first versions of Salzburg's Random Polygon Generator, {@code .poly}: the limits
 * of x and y, the number of points, the points, the number of polygons, and for each a line {@code
 * POLYGON} and its vertices in order, one a line, as numbers of points from 1 on.
 */
public final class RpgFormat implements Format {
  private static final String NUMBER = "[-+.0-9eE]+";
  private static final Pattern LIMITS = Pattern.compile(NUMBER + "(\\s+" + NUMBER + "){3}");
  private static final Pattern COUNT = Pattern.compile("[0-9]{1,9}");
  private static final Pattern POINT = Pattern.compile(NUMBER + "\\s+" + NUMBER);
  private static final String POLYGON = "POLYGON";
  private static final int SMALLEST_RING = 3;

  @Override
  public String title() {
    return "RPG";
  }

  @Override
  public boolean fits(Head head) {
    return Rows.startsWith(head, LIMITS, COUNT, POINT)
        || (Rows.startsWith(head, COUNT, POINT) && Rows.of(head).anyMatch(POLYGON::equals));
  }

  @Override
  public Shapes read(Input input) throws IOException {
    Rows rows = new Rows(input);
    rows.next(0, 1, "counts");
    if (rows.words().size() > 1) {
      rows.next(0, 1, "counts"); // behind the limits
    }
    PointColumns points = rows.points(rows.count(0));
    if (!rows.next()) {
      return Shapes.of(title(), Shape.of(Shape.Kind.SITES, "", points));
    }
    int polygons = rows.count(0);
    Points all = points.points();
    List<Shape> shapes = new ArrayList<>();
    boolean goesOn = rows.next();
    while (goesOn && shapes.size() < polygons) {
      PointColumns ring = new PointColumns();
      goesOn = ring(rows, all, ring);
      shapes.add(Shape.of(Shape.Kind.RING, "", ring));
    }
    if (goesOn || shapes.size() < polygons) {
      throw rows.fault(
          "the number of polygons is "
              + polygons
              + ", but "
              + (goesOn ? "more" : shapes.size())
              + " follow; correct it");
    }
    return new Shapes(title(), shapes, List.of());
  }

  /** Reads the vertices behind a line POLYGON, up to the next one; whether there is one. */
  private static boolean ring(Rows rows, Points points, PointColumns ring) throws IOException {
    if (!rows.words().get(0).equalsIgnoreCase(POLYGON)) {
      throw rows.fault("a line POLYGON is missing before the vertices of a polygon; insert it");
    }
    boolean goesOn = rows.next();
    while (goesOn && !rows.words().get(0).equalsIgnoreCase(POLYGON)) {
      int i = rows.whole(0);
      if (i < 1 || i > points.size()) {
        throw rows.fault(
            "there is no point " + i + ", they are numbered from 1 to " + points.size());
      }
      ring.add(points.x(i - 1), points.y(i - 1), rows.line());
      goesOn = rows.next();
    }
    if (ring.size() < SMALLEST_RING) {
      throw rows.fault("a polygon has " + ring.size() + " vertices, but it needs 3; add vertices");
    }
    return goesOn;
  }
}
