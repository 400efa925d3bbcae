package dct.io.format.drawing;

import dct.io.text.Shown;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The subpaths in the data of a path of SVG, if all of their edges are straight. */
final class SvgPath {
  private static final String PLACE = "the path data";

  private final XmlText xml;
  private final int line;
  private final Affine matrix;
  private final NumberText data;
  private final List<Outline> outlines = new ArrayList<>();
  private final Coordinate x = new Coordinate();
  private final Coordinate y = new Coordinate();
  private final Coordinate startX = new Coordinate();
  private final Coordinate startY = new Coordinate();
  private Outline outline;

  private SvgPath(XmlText xml, String data, int line, Affine matrix) {
    this.xml = xml;
    this.line = line;
    this.matrix = matrix;
    this.data = new NumberText(data);
  }

  /**
   * Reads path data.
   *
   * @return nothing if a command draws a curve
   * @throws dct.io.text.BadInputException if there is something else than commands and numbers
   */
  static Optional<List<Outline>> read(XmlText xml, String data, int line, Affine matrix) {
    SvgPath path = new SvgPath(xml, data, line, matrix);
    return path.isStraight() ? Optional.of(path.outlines) : Optional.empty();
  }

  private boolean isStraight() {
    data.skipSpace();
    while (!data.isAtEnd()) {
      char command = data.peek();
      if ("CcSsQqTtAa".indexOf(command) >= 0) {
        return false;
      }
      boolean isMove = command == 'M' || command == 'm';
      if ("MmLlHhVvZz".indexOf(command) < 0 || (!isMove && outlines.isEmpty())) {
        throw xml.fault(line, unknown());
      }
      data.advance();
      run(command);
      data.skipSpace();
    }
    return true;
  }

  private String unknown() {
    String word = Shown.word(data.word());
    return "\"" + word + "\" in " + PLACE + " is no command to move or draw there; correct it";
  }

  private void run(char command) {
    boolean isRelative = command >= 'a';
    switch (command) {
      case 'M', 'm' -> move(isRelative);
      case 'Z', 'z' -> close();
      default -> {
        do {
          draw(command, isRelative);
        } while (isNextNumber());
      }
    }
  }

  private void move(boolean isRelative) {
    step(x, isRelative);
    step(y, isRelative);
    startX.set(x);
    startY.set(y);
    begin();
    while (isNextNumber()) {
      draw('L', isRelative);
    }
  }

  private void begin() {
    outline = new Outline(xml, matrix);
    outlines.add(outline);
    outline.add(x.value(), y.value(), line);
  }

  private void close() {
    outline.close();
    x.set(startX);
    y.set(startY);
  }

  private void draw(char command, boolean isRelative) {
    if (outline.isClosed()) {
      begin();
    }
    if (command != 'V' && command != 'v') {
      step(x, isRelative);
    }
    if (command != 'H' && command != 'h') {
      step(y, isRelative);
    }
    outline.add(x.value(), y.value(), line);
  }

  private void step(Coordinate coordinate, boolean isRelative) {
    data.skipComma();
    double number = data.number();
    if (Double.isNaN(number)) {
      throw xml.noNumber(line, data.word(), PLACE);
    }
    xml.checkFinite(number, 0, line);
    if (isRelative) {
      coordinate.moveBy(number, data.written());
    } else {
      coordinate.moveTo(number, data.written());
    }
  }

  private boolean isNextNumber() {
    data.skipComma();
    return data.isAtNumber();
  }
}
