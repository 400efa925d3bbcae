package dct.io.format.wkt;

import dct.io.format.Input;
import dct.io.format.PointColumns;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.text.ByteScanner;
import dct.io.text.Shown;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * Reads geometries of Well-Known Text. A POINT or MULTIPOINT is sites, all points of one geometry
 * together; a line is a path, or a ring if it is closed; a hole follows its ring. z and m are left
 * out.
 */
final class WktReader {
  static final String TITLE = "WKT";
  private static final int DEEPEST = 100;
  private static final String XY = "write two numbers x y for each point";

  private final ByteScanner scanner;
  private final List<Shape> shapes = new ArrayList<>();
  private int beyond; // numbers behind x and y
  private int empty; // geometries without points

  private WktReader(Input input) {
    scanner = new ByteScanner(input.name(), input.in());
  }

  static Shapes read(Input input) throws IOException {
    WktReader reader = new WktReader(input);
    while (reader.isMore()) {
      reader.geometry(0);
    }
    return reader.shapes();
  }

  private Shapes shapes() {
    if (shapes.isEmpty()) {
      throw scanner.fault("all geometries are empty; write a POLYGON or MULTIPOINT with points");
    }
    List<String> notes = new ArrayList<>();
    if (beyond > 0) {
      notes.add("z and m behind x and y are left out");
    }
    if (empty > 0) {
      notes.add(empty == 1 ? "1 empty geometry is left out" : empty + " empty ones are left out");
    }
    return new Shapes(TITLE, shapes, notes);
  }

  /** Skips what may stand between geometries; says whether another follows. */
  private boolean isMore() throws IOException {
    while (true) {
      int b = scanner.skipBlanks();
      if (b == '#') {
        scanner.skipLine();
      } else if (b == ';' || b == ',') {
        scanner.take();
      } else {
        return b != ByteScanner.END;
      }
    }
  }

  private void geometry(int depth) throws IOException {
    if (depth > DEEPEST) {
      throw scanner.fault("collections are nested deeper than " + DEEPEST + "; flatten them");
    }
    String type = scanner.word();
    if (type.equals("SRID") && scanner.skip('=')) {
      scanner.word();
      scanner.skip(';');
      type = scanner.word();
    }
    String plain = type.replaceFirst("(ZM|Z|M)$", "");
    String mark = isType(plain) ? plain : type;
    if (!isType(mark)) {
      throw unknown(type);
    }
    if (scanner.skipBlanks() != '(') {
      String word = scanner.word();
      String then = word.matches("Z|M|ZM") && scanner.skipBlanks() != '(' ? scanner.word() : word;
      if (then.equals("EMPTY")) {
        empty++;
        return;
      }
    }
    body(mark, depth);
  }

  private static boolean isType(String word) {
    return switch (word) {
      case "POINT",
          "MULTIPOINT",
          "LINESTRING",
          "LINEARRING",
          "POLYGON",
          "TRIANGLE",
          "MULTILINESTRING",
          "MULTIPOLYGON",
          "POLYHEDRALSURFACE",
          "TIN",
          "GEOMETRYCOLLECTION" ->
          true;
      default -> false;
    };
  }

  private RuntimeException unknown(String type) throws IOException {
    if (type.matches(".*(CURVE|CIRCULAR|SURFACE).*")) {
      return scanner.fault(type + " has curves, which are not read; write straight lines");
    }
    String found = type.isEmpty() ? scanner.found() : "\"" + Shown.word(type) + "\"";
    return scanner.fault(found + " is no geometry of WKT; write POLYGON ((x y, …))");
  }

  private void body(String type, int depth) throws IOException {
    switch (type) {
      case "POINT", "MULTIPOINT" -> points();
      case "LINESTRING", "LINEARRING" -> line();
      case "POLYGON", "TRIANGLE" -> polygon();
      case "MULTILINESTRING" -> list(this::line);
      case "MULTIPOLYGON", "POLYHEDRALSURFACE", "TIN" -> list(this::polygon);
      default -> list(() -> geometry(depth + 1));
    }
  }

  /** Reads one element of a list. */
  @FunctionalInterface
  private interface Element {
    void read() throws IOException;
  }

  private void list(Element element) throws IOException {
    open();
    do {
      element.read();
    } while (scanner.skip(','));
    close();
  }

  private void open() throws IOException {
    if (!scanner.skip('(')) {
      throw scanner.fault(scanner.found() + " stands where ( is missing; write it");
    }
  }

  private void close() throws IOException {
    if (!scanner.skip(')')) {
      throw scanner.fault(scanner.found() + " stands where , or ) is missing; write it");
    }
  }

  private void points() throws IOException {
    PointColumns columns = new PointColumns();
    list(
        () -> {
          if (isEmpty()) {
            return;
          }
          boolean inner = scanner.skip('(');
          point(columns);
          if (inner) {
            close();
          }
        });
    if (columns.size() > 0) {
      shapes.add(Shape.of(Shape.Kind.SITES, "", columns));
    }
  }

  /** Whether EMPTY stands in the place of a list; it is read then. */
  private boolean isEmpty() throws IOException {
    int b = scanner.skipBlanks();
    if (b != 'E' && b != 'e') {
      return false;
    }
    String word = scanner.word();
    if (!word.equals("EMPTY")) {
      throw scanner.fault("\"" + Shown.word(word) + "\" stands where ( is missing; write it");
    }
    empty++;
    return true;
  }

  private void line() throws IOException {
    if (isEmpty()) {
      return;
    }
    PointColumns columns = coordinates();
    boolean closed = columns.size() > 3 && columns.isClosed();
    add(closed ? Shape.Kind.RING : Shape.Kind.PATH, columns, closed);
  }

  private void polygon() throws IOException {
    if (isEmpty()) {
      return;
    }
    boolean[] isHole = new boolean[1];
    list(
        () -> {
          if (isEmpty()) {
            return;
          }
          PointColumns ring = coordinates();
          add(isHole[0] ? Shape.Kind.HOLE : Shape.Kind.RING, ring, ring.isClosed());
          isHole[0] = true;
        });
  }

  private void add(Shape.Kind kind, PointColumns columns, boolean closed) {
    if (closed) {
      columns.removeLast(); // WKT repeats the first
    }
    shapes.add(Shape.of(kind, "", columns));
  }

  private PointColumns coordinates() throws IOException {
    PointColumns columns = new PointColumns();
    list(() -> point(columns));
    return columns;
  }

  private void point(PointColumns columns) throws IOException {
    int line = scanner.line();
    double x = scanner.number(XY);
    columns.add(x, scanner.number(XY), line);
    for (int more = 0; more < 2 && scanner.isNumberNext(); more++) {
      scanner.number(XY);
      beyond++;
    }
  }
}
