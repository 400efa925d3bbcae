package dct.io.format.plain;

import dct.core.geometry.Points;
import dct.io.format.PointColumns;
import dct.io.format.Shape;
import dct.io.text.BadInputException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Files of polypartition: in the first line the number of polygons, then each behind the number of
 * its vertices and 0, or 1 if it is a hole. They are told where all counts fit to the last row.
 */
final class CountedPolygons {
  private static final int SMALLEST_RING = 3;

  private final String name;
  private final Points rows;
  private final int[] lines;

  /** The rows behind the first line of a text that messages call by this name. */
  CountedPolygons(String name, Points rows, int[] lines) {
    this.name = name;
    this.rows = rows;
    this.lines = lines;
  }

  /**
   * The polygons; nothing if the first line must be something else.
   *
   * @param count what it holds
   * @param line its number
   * @throws BadInputException if a count is wrong
   */
  Optional<List<Shape>> shapes(int count, int line) {
    List<Shape> shapes = new ArrayList<>();
    int head = 0;
    while (head < rows.size() && isHead(head) && rows.x(head) < rows.size() - head) {
      shapes.add(shape(head));
      head += (int) rows.x(head) + 1;
    }
    if (head < rows.size()) {
      boolean mayBe = count <= rows.size() / (SMALLEST_RING + 1) && isHead(0);
      if (mayBe && count != rows.size()) {
        throw fault(head);
      }
      return Optional.empty();
    }
    if (shapes.size() != count) {
      throw wrong(line, count, "polygons", shapes.size());
    }
    return Optional.of(shapes);
  }

  /** What is wrong in the row where a polygon should start. */
  private BadInputException fault(int head) {
    return isHead(head)
        ? wrong(lines[head], (int) rows.x(head), "vertices", rows.size() - head - 1)
        : new BadInputException(
            name,
            lines[head],
            "the next polygon does not start here with a count and 0 or 1; correct the counts");
  }

  /** Whether a row can be the number of vertices of a polygon, and whether it is a hole. */
  private boolean isHead(int row) {
    double x = rows.x(row);
    double y = rows.y(row);
    return x >= SMALLEST_RING && x == (int) x && (y == 0 || y == 1);
  }

  private Shape shape(int head) {
    PointColumns ring = new PointColumns();
    for (int i = head + 1; i <= head + (int) rows.x(head); i++) {
      ring.add(rows.x(i), rows.y(i), lines[i]);
    }
    return Shape.of(rows.y(head) == 1 ? Shape.Kind.HOLE : Shape.Kind.RING, "", ring);
  }

  private BadInputException wrong(int line, int count, String things, int follow) {
    String fault = "this looks like a count of " + count + " " + things + ", but " + follow;
    return new BadInputException(name, line, fault + " follow; correct the count");
  }
}
