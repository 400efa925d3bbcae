package dct.io.format.lists;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.PointColumns;
import dct.io.format.Rows;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import java.io.IOException;
import java.util.regex.Pattern;

/**
 * Input of Qhull, as its {@code rbox} writes it: a line with the dimension and perhaps a comment,
 * one with the number of points, then the points. The two lines may be exchanged.
 */
public final class QhullFormat implements Format {
  private static final Pattern FIRST = Pattern.compile("[0-9]+(\\s+[A-Za-z].*)?");
  private static final Pattern SECOND = Pattern.compile("[0-9]+");
  private static final Pattern POINT = Pattern.compile("[^ \t]+[ \t].*");
  private static final int PLANE = 2;

  @Override
  public String title() {
    return "Qhull";
  }

  @Override
  public boolean fits(Head head) {
    return Rows.startsWith(head, FIRST, SECOND, POINT)
        || (Rows.startsWith(head, FIRST, SECOND) && Rows.of(head).limit(3).count() == 2);
  }

  @Override
  public Shapes read(Input input) throws IOException {
    Rows rows = new Rows(input);
    rows.next(0, 1, "dimensions");
    int first = rows.count(0);
    rows.next(0, 1, "counts");
    int second = rows.count(0);
    int dimension = Math.min(first, second);
    int count = Math.max(first, second);
    if (dimension != PLANE) {
      throw rows.fault(
          "the points of this input of Qhull have "
              + dimension
              + " coordinates; write points of the plane, behind the dimension 2");
    }
    PointColumns points = rows.points(count);
    rows.end("its last point", "count");
    return Shapes.of(title(), Shape.of(Shape.Kind.SITES, "", points));
  }
}
