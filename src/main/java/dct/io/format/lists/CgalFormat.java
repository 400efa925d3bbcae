package dct.io.format.lists;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.PointColumns;
import dct.io.format.Rows;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.format.plain.PlainFormat;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/**
 * Polygons as CGAL prints them, one a line: the number of vertices, then x and y in turn. Behind an
 * outer boundary the number of its holes and the holes may follow.
 */
public final class CgalFormat implements Format {
  private static final Pattern COUNT = Pattern.compile("[0-9]{1,9}");
  private static final int SMALLEST_RING = 3;

  @Override
  public String title() {
    return "CGAL";
  }

  /** A table is as wide everywhere, and not all its rows start with their number of vertices. */
  @Override
  public boolean fits(Head head) {
    List<String[]> lines = Rows.of(head).map(line -> line.split("\\s+")).toList();
    if (lines.size() == 1 && head.isCut()) {
      return isStart(lines.get(0));
    }
    boolean isCut = lines.size() > 1 && !head.text().endsWith("\n");
    List<String[]> complete = isCut ? lines.subList(0, lines.size() - 1) : lines;
    return !lines.isEmpty()
        && isPolygon(lines.get(0))
        && (complete.stream().allMatch(CgalFormat::isPolygon)
            || complete.stream().anyMatch(line -> line.length != lines.get(0).length));
  }

  /** Whether it can be the start of a line that begins with a count, which is not reached. */
  private static boolean isStart(String[] words) {
    return COUNT.matcher(words[0]).matches() && 2L * Integer.parseInt(words[0]) > words.length - 2;
  }

  private static boolean isPolygon(String[] words) {
    int i = behindRing(words, 0);
    if (i > 0 && i < words.length && COUNT.matcher(words[i]).matches()) {
      int holes = Integer.parseInt(words[i++]);
      for (int h = 0; h < holes && i > 0; h++) {
        i = behindRing(words, i);
      }
    }
    return i == words.length;
  }

  /** The place behind a ring that starts there with its count; -1 if it does not fit. */
  private static int behindRing(String[] words, int from) {
    if (from >= words.length || !COUNT.matcher(words[from]).matches()) {
      return -1;
    }
    long size = Integer.parseInt(words[from]);
    long behind = from + 1 + 2 * size;
    return size < SMALLEST_RING || behind > words.length ? -1 : (int) behind;
  }

  @Override
  public Shapes read(Input input) throws IOException {
    if (input.columns().xy().isPresent() || input.columns().skipped() > 0) {
      return new PlainFormat().read(input); // the user says that it is a table
    }
    Rows rows = new Rows(input);
    List<Shape> shapes = new ArrayList<>();
    boolean mayBePairs = false;
    while (rows.next()) {
      int i = ring(rows, 0, Shape.Kind.RING, shapes);
      int size = rows.words().size();
      int holes = i < size ? rows.count(i++) : 0;
      for (int h = 0; h < holes; h++) {
        i = ring(rows, i, Shape.Kind.HOLE, shapes);
      }
      if (i < size) {
        throw rows.fault("the line goes on behind its last vertex; correct the count");
      }
      mayBePairs = size % 2 == 0 && holes == 0;
    }
    if (mayBePairs && shapes.size() == 1) {
      int vertices = shapes.get(0).points().size();
      throw rows.fault(
          "these can be a count, "
              + vertices
              + " vertices and no holes, or "
              + (vertices + 1)
              + " vertices; write one vertex a line");
    }
    return new Shapes(title(), shapes, List.of());
  }

  /** Reads a ring behind its count; returns the place behind it. */
  private static int ring(Rows rows, int from, Shape.Kind kind, List<Shape> shapes) {
    int size = rows.count(from);
    int numbers = rows.words().size() - from - 1;
    if (size < SMALLEST_RING) {
      throw rows.fault(
          "the count of the polygon is " + size + ", but it needs 3 vertices; correct the line");
    }
    if (size > numbers / 2) {
      throw rows.fault(
          "this looks like a count of "
              + size
              + " vertices, but "
              + numbers
              + " numbers follow in the line; correct the line");
    }
    PointColumns ring = new PointColumns();
    for (int v = 0; v < size; v++) {
      int x = from + 1 + 2 * v;
      ring.add(rows.number(x), rows.number(x + 1), rows.line());
    }
    shapes.add(Shape.of(kind, "", ring));
    return from + 1 + 2 * size;
  }
}
