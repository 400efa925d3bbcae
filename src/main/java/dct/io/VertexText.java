package dct.io;

import dct.core.Decimals;
import dct.core.triangulate.Domain;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/**
 * Reads the program's own text format: a vertex a line, {@code x y}.
 *
 * <p>The numbers are separated by blanks, tabs, one comma or one semicolon. {@code #} starts a
 * comment; blank lines are skipped. A comment line {@code # kind: polygon} or {@code # kind:
 * points} says what the points are. Linear; ordinary lines make no objects.
 */
final class VertexText {
  private static final String KIND = "# kind:";

  private final String name;
  private final ByteLines lines;
  private final PointColumns points = new PointColumns();
  private Optional<Domain> kind = Optional.empty();

  private VertexText(String name, ByteLines lines) {
    this.name = name;
    this.lines = lines;
  }

  /**
   * Reads everything.
   *
   * @throws BadInputException at the first line that is wrong
   */
  static PointDocument read(String name, InputStream in) throws IOException {
    VertexText text = new VertexText(name, new ByteLines(in));
    while (text.lines.next()) {
      text.line();
    }
    return text.document();
  }

  private PointDocument document() {
    if (points.size() == 0) {
      throw new BadInputException(
          name,
          Math.max(1, lines.number()),
          (lines.number() == 0 ? "the file is empty" : "there is no vertex in the file")
              + "; write one vertex a line, as two numbers x y");
    }
    return new PointDocument(name, kind, points.points(), points.lines());
  }

  private void line() {
    byte[] bytes = lines.bytes();
    int xFrom = skipBlanks(lines.start());
    if (isRest(xFrom) && !lines.isCut()) {
      comment(xFrom);
      return;
    }
    int xTo = tokenEnd(xFrom);
    int yFrom = skipSeparator(xTo);
    int yTo = tokenEnd(yFrom);
    int rest = skipSeparator(yTo);
    double px = Decimals.parse(bytes, xFrom, xTo);
    double py = Decimals.parse(bytes, yFrom, yTo);
    if (!Double.isFinite(px) || !Double.isFinite(py) || !isRest(rest) || lines.isCut()) {
      throw new LineFault(name, lines).exception();
    }
    comment(rest);
    points.add(px, py, lines.number());
  }

  private int skipBlanks(int from) {
    int i = from;
    while (i < lines.end() && isBlank(lines.bytes()[i])) {
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

  static boolean isBlank(byte b) {
    return b == ' ' || b == '\t' || b == 0x0B || b == '\f';
  }

  private static boolean endsToken(byte b) {
    return isBlank(b) || b == ',' || b == ';' || b == '#';
  }

  private boolean isRest(int i) {
    return i == lines.end() || lines.bytes()[i] == '#';
  }

  private void comment(int from) {
    byte[] bytes = lines.bytes();
    for (int i = from; i < lines.end(); i++) {
      if (bytes[i] < ' ' && !isBlank(bytes[i])) { // control characters and, below zero, non-ASCII
        new LineFault(name, lines).throwIfNotText();
        break;
      }
    }
    if (points.size() == 0 && from < lines.end()) {
      readKind(new String(bytes, from, lines.end() - from, StandardCharsets.UTF_8));
    }
  }

  private void readKind(String comment) {
    if (comment.startsWith(KIND)) {
      kind = Domain.parse(comment.substring(KIND.length()).strip()).or(() -> kind);
    }
  }

  /** The comment line that says what the points are. */
  static String kindLine(Domain domain) {
    return KIND + " " + domain.word();
  }
}
