package dct.io.format.plain;

import dct.core.Decimals;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.format.Columns;
import dct.io.format.Input;
import dct.io.format.PointColumns;
import dct.io.format.RegionShape;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.text.BadInputException;
import dct.io.text.ByteLines;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/**
 * Reads text with a vertex a line: the program's own, {@code x y}, and what others write.
 *
 * <p>The numbers are separated by blanks, tabs, one comma or one semicolon. {@code #} at the start
 * of a line or after a blank, a comma or a semicolon starts a comment; blank lines are skipped, but
 * where they part groups of vertices that could be rings, each is a shape. A comment line {@code #
 * kind: polygon} or {@code # kind: points} says what the points are. A line {@code hole} starts the
 * next ring of a region, {@code sites} what is on no ring, and {@code fixed i j} fixes the edge
 * between two vertices, numbered from 0 on in the order of the file. A first line with nothing but
 * the number of vertices that follow is skipped, too; every other line of counts is refused. {@link
 * LooseLine} says what else a line may look like, {@link Table} which columns are read. Linear;
 * lines of two numbers make no objects.
 */
public final class VertexText {
  private static final Pattern KIND =
      Pattern.compile("#\\s*kind\\s*:\\s*(\\w+)\\s*", Pattern.CASE_INSENSITIVE);

  private static final Pattern PART = Pattern.compile("(?i:hole|steiner)|sites");
  private static final Pattern OWN_PART = Pattern.compile("hole|sites");
  private static final Pattern FIXED =
      Pattern.compile("fixed\\s+([0-9]{1,9})(?:\\s*[,;]\\s*|\\s+)([0-9]{1,9})");
  private static final Pattern EXCEL = Pattern.compile("sep=.", Pattern.CASE_INSENSITIVE);

  private final String name;
  private final ByteLines lines;
  private final Table table;
  private final List<String> notes = new ArrayList<>();
  private final Columns columns;
  private final List<Part> parts =
      new ArrayList<>(); // what follows the words of poly2tri, or hole, sites
  private final FixedEdges fixed;
  private boolean isRegion; // a word of the program's own says so
  private final TextLayout layout;
  private final LooseLine line = new LooseLine();
  private Optional<Domain> kind = Optional.empty();

  private VertexText(String name, ByteLines lines, Columns columns) {
    this.name = name;
    this.lines = lines;
    this.columns = columns;
    this.table = new Table(name);
    this.layout = new TextLayout(name);
    this.fixed = new FixedEdges(name);
  }

  /**
   * Reads everything.
   *
   * @throws BadInputException at the first line that is wrong
   */
  static Shapes read(Input input) throws IOException {
    VertexText text = new VertexText(input.name(), new ByteLines(input.in()), input.columns());
    while (text.lines.next()) {
      if (text.lines.number() > input.columns().skipped()) {
        text.line();
      } else {
        text.lines.skipRest();
      }
    }
    return text.shapes();
  }

  private Shapes shapes() {
    if (table.size() == 0) {
      throw new BadInputException(
          name,
          Math.max(1, lines.number()),
          (lines.number() == 0
                  ? "the file is empty"
                  : layout.hasCount()
                      ? "there is only one number"
                      : "there is no vertex in the file")
              + "; write one vertex a line, as two numbers x y");
    }
    PointColumns points = table.points(columns.xy(), notes);
    Points read = points.points();
    int[] numbers = points.lines();
    if (isRegion || kind.equals(Optional.of(Domain.REGION))) {
      return region(read, numbers);
    }
    boolean isCertain = kind.isPresent() || columns.skipped() > 0 || table.hasHeader();
    if (!isCertain && layout.polygons() > 0) {
      Optional<List<Shape>> polygons =
          new CountedPolygons(name, read, numbers).shapes(layout.polygons(), layout.countLine());
      if (polygons.isPresent()) {
        return new Shapes(PlainFormat.TITLE, polygons.get(), notes);
      }
    }
    if (!isCertain) { // else the program wrote it, or its reader has looked at the first line
      layout.check(read, numbers);
    }
    if (!isCertain && layout.startsWhole()) {
      Optional<List<Shape>> counted = CountedText.shapes(read, numbers, notes);
      if (counted.isPresent()) {
        return new Shapes(PlainFormat.TITLE, counted.get(), notes);
      }
    }
    return new Shapes(PlainFormat.TITLE, shapes(read, numbers), notes);
  }

  private Shapes region(Points read, int[] numbers) {
    List<Shape> shapes =
        shapes(read, numbers, parts.isEmpty() ? layout.groups(read.size()) : starts());
    int[] ends = fixed.ends(read.size());
    int empty = parts.size() + 1 - shapes.size();
    if (!parts.isEmpty() && empty > 0) {
      notes.add(
          empty == 1
              ? "1 ring or list of sites without vertices is left out"
              : empty + " rings or lists of sites without vertices are left out");
    }
    Optional<Shapes.Whole> whole =
        ends.length == 0
            ? Optional.empty()
            : Optional.of(new Shapes.Whole(RegionShape.of(shapes, ends), notes));
    return new Shapes(PlainFormat.TITLE, shapes, notes, whole, true);
  }

  /** Where a ring or the sites begin. */
  private int[] starts() {
    return IntStream.concat(IntStream.of(0), parts.stream().mapToInt(Part::start))
        .distinct()
        .toArray();
  }

  /**
   * A word of poly2tri, or of the program's own.
   *
   * @param start the first vertex behind it
   * @param kind what the vertices behind it are
   */
  private record Part(int start, Shape.Kind kind) {}

  private static Shape.Kind kind(String word) {
    return word.equalsIgnoreCase("hole") ? Shape.Kind.HOLE : Shape.Kind.SITES;
  }

  /** What the group that starts there is. */
  private Shape.Kind kindAt(int start, Shape.Kind otherwise) {
    Shape.Kind first = parts.isEmpty() ? otherwise : Shape.Kind.RING;
    return parts.stream()
        .filter(part -> part.start == start)
        .map(Part::kind)
        .findFirst()
        .orElse(first);
  }

  private List<Shape> shapes(Points read, int[] numbers) {
    Shape.Kind is =
        kind.map(domain -> domain == Domain.SITES ? Shape.Kind.SITES : Shape.Kind.RING)
            .orElse(Shape.Kind.POINTS);
    return shapes(
        read, numbers, is == Shape.Kind.SITES ? new int[1] : layout.groups(read.size()), is);
  }

  private List<Shape> shapes(Points read, int[] numbers, int[] starts) {
    return shapes(read, numbers, starts, Shape.Kind.RING);
  }

  private List<Shape> shapes(Points read, int[] numbers, int[] starts, Shape.Kind is) {
    List<Shape> shapes = new ArrayList<>();
    for (int g = 0; g < starts.length; g++) {
      int end = g + 1 < starts.length ? starts[g + 1] : read.size();
      PointColumns group = new PointColumns();
      for (int v = starts[g]; v < end; v++) {
        group.add(read.x(v), read.y(v), numbers[v]);
      }
      if (group.size() > 0) {
        shapes.add(Shape.of(kindAt(starts[g], is), "", group));
      }
    }
    return shapes;
  }

  private void line() throws IOException {
    byte[] bytes = lines.bytes();
    int xFrom = skipBlanks(lines.start());
    if (isRest(xFrom) && !(lines.isCut() && xFrom == lines.end())) {
      if (xFrom == lines.end()) {
        layout.blankLine(table.size());
      }
      comment(xFrom);
      lines.skipRest();
      return;
    }
    int xTo = tokenEnd(xFrom);
    int yFrom = skipSeparator(xTo);
    int yTo = tokenEnd(yFrom);
    int rest = skipSeparator(yTo);
    double px = Decimals.parse(bytes, xFrom, xTo);
    double py = Decimals.parse(bytes, yFrom, yTo);
    if (!Double.isFinite(px) || !Double.isFinite(py) || !isRest(rest) || lines.isCut()) {
      if (!isOnly(xFrom, xTo) || !layout.isCount(px, table.size(), lines.number())) {
        loose();
      }
      return;
    }
    comment(rest);
    layout.vertex(table.size(), isWhole(xFrom, xTo), isWhole(yFrom, yTo), bytes[xTo]);
    table.add(px, py, lines.number());
  }

  /** Reads a line that is not just two numbers. */
  private void loose() {
    LineFault fault = new LineFault(name, lines);
    fault.throwIfNotText();
    if (lines.isCut()) {
      throw fault.exception();
    }
    line.take(lines);
    if (line.isEmpty()) {
      return;
    }
    if (line.first() == '>') { // of the Generic Mapping Tools
      layout.blankLine(table.size());
      return;
    }
    if (table.size() == 0 && isHead(line.data())) {
      return;
    }
    if (startsPart()) {
      return;
    }
    NumberScan rows = line.rows().orElseThrow(fault::exception);
    for (int row = 0; row < rows.rows(); row++) {
      if (rows.size(row) < 2) {
        throw fault.exception();
      }
      table.add(rows, row, lines.number());
      layout.vertex(table.size() - 1, false, false, (byte) ' ');
    }
  }

  /** Whether the line is a word of poly2tri or of the program's own. */
  private boolean startsPart() {
    if (!Character.isLetter(line.first())) {
      return false;
    }
    String data = line.data();
    Matcher edge = FIXED.matcher(data);
    boolean isEdge = edge.matches();
    boolean isPart = !isEdge && PART.matcher(data).matches();
    if (isEdge) {
      fixed.add(Integer.parseInt(edge.group(1)), Integer.parseInt(edge.group(2)), lines.number());
    } else if (isPart) {
      layout.ring(table.size());
      parts.add(new Part(table.size(), kind(data)));
    }
    isRegion |= isEdge || (isPart && OWN_PART.matcher(data).matches());
    return isEdge || isPart;
  }

  /** Whether it is a line above the numbers: Excel's separator, or the names of the columns. */
  private boolean isHead(String data) {
    if (EXCEL.matcher(data).matches()) {
      notes.add("The line that names Excel's separator is left out");
      return true;
    }
    Optional<HeaderRow> header = table.hasHeader() ? Optional.empty() : HeaderRow.of(data);
    header.ifPresent(table::header);
    return header.isPresent();
  }

  /** Whether this whole number is all that the line holds. */
  private boolean isOnly(int from, int to) {
    return from < to && isWhole(from, to) && isRest(skipBlanks(to)) && !lines.isCut();
  }

  /** Whether these are digits only. */
  private boolean isWhole(int from, int to) {
    for (int i = from; i < to; i++) {
      if (lines.bytes()[i] < '0' || lines.bytes()[i] > '9') {
        return false;
      }
    }
    return true;
  }

  private int skipBlanks(int from) {
    int i = from;
    while (i < lines.end() && ByteLines.isBlank(lines.bytes()[i])) {
      i++;
    }
    return i;
  }

  private int skipSeparator(int from) {
    int i = skipBlanks(from);
    boolean separated = i < lines.end() && (lines.bytes()[i] == ',' || lines.bytes()[i] == ';');
    return separated ? skipBlanks(i + 1) : i;
  }

  private int tokenEnd(int from) {
    int i = from;
    while (i < lines.end() && !endsToken(lines.bytes()[i])) {
      i++;
    }
    return i;
  }

  private static boolean endsToken(byte b) {
    return ByteLines.isBlank(b) || b == ',' || b == ';';
  }

  private boolean isRest(int i) {
    return i == lines.end() || lines.bytes()[i] == '#';
  }

  private void comment(int from) {
    byte[] bytes = lines.bytes();
    for (int i = from; i < lines.end(); i++) {
      if (bytes[i] < ' '
          && !ByteLines.isBlank(bytes[i])) { // control characters and, below zero, non-ASCII
        new LineFault(name, lines).throwIfNotText();
        break;
      }
    }
    if (table.size() == 0 && from < lines.end()) {
      readKind(new String(bytes, from, lines.end() - from, StandardCharsets.UTF_8));
    }
  }

  private void readKind(String comment) {
    Matcher matcher = KIND.matcher(comment);
    if (matcher.matches()) {
      kind = Domain.parse(matcher.group(1).toLowerCase(Locale.ROOT)).or(() -> kind);
    }
  }

  /** The comment line that says what the points are. */
  public static String kindLine(Domain domain) {
    return "# kind: " + domain.word();
  }
}
