package dct.io.format.drawing;

import dct.core.Decimals;
import dct.io.text.Shown;
import java.util.function.Supplier;

/** The subpaths in the text of a path of Ipe; those that are not straight are left out. */
final class IpePath {
  private static final String PLACE = "the path";
  private static final String CURVES = "qcCLsa";

  private final XmlText xml;
  private final DrawnShapes shapes;
  private final Affine matrix;
  private final Supplier<String> label;
  private final double[] last = new double[6]; // numbers, the newest at the end
  private int numbers; // since the last operator
  private int line;
  private Outline outline; // of the subpath that is open, if one is
  private boolean isCurved;

  /** Paths with this label, whose coordinates are mapped. */
  IpePath(XmlText xml, DrawnShapes shapes, Affine matrix, Supplier<String> label) {
    this.xml = xml;
    this.shapes = shapes;
    this.matrix = matrix;
    this.label = label;
  }

  /**
   * Adds all subpaths to the shapes.
   *
   * @param text numbers, each behind them an operator
   * @param start the line in which the text starts
   * @throws dct.io.text.BadInputException if there is something else
   */
  void add(String text, int start) {
    line = start;
    int at = 0;
    while (at < text.length()) {
      char c = text.charAt(at);
      if (isSpace(c)) {
        line += c == '\n' ? 1 : 0;
        at++;
      } else {
        int end = at;
        while (end < text.length() && !isSpace(text.charAt(end))) {
          end++;
        }
        word(text.substring(at, end));
        at = end;
      }
    }
    if (numbers > 0) {
      throw xml.fault(line, "the path ends without an operator behind its numbers; complete it");
    }
    finish();
  }

  private static boolean isSpace(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
  }

  private void word(String word) {
    double number = Decimals.parse(word);
    if (!Double.isNaN(number)) {
      System.arraycopy(last, 1, last, 0, last.length - 1);
      last[last.length - 1] = number;
      numbers++;
    } else if (word.length() == 1 && Character.isLetter(word.charAt(0))) {
      operator(word.charAt(0));
      numbers = 0;
    } else {
      throw xml.noNumber(line, word, PLACE);
    }
  }

  private void operator(char operator) {
    switch (operator) {
      case 'm' -> {
        finish();
        outline = new Outline(xml, matrix);
        vertex(operator);
      }
      case 'l' -> {
        checkOpen(operator);
        vertex(operator);
      }
      case 'h' -> {
        checkOpen(operator);
        outline.close();
        finish();
      }
      case 'e' -> {
        finish();
        ellipse();
      }
      case 'u' -> {
        finish();
        shapes.leaveOut(LeftOut.CURVED);
      }
      default -> curve(operator);
    }
  }

  private void curve(char operator) {
    if (CURVES.indexOf(operator) < 0) {
      String word = Shown.word(String.valueOf(operator));
      throw xml.fault(line, "\"" + word + "\" in " + PLACE + " is no operator of Ipe; correct it");
    }
    checkOpen(operator);
    isCurved = true;
  }

  private void vertex(char operator) {
    checkNumbers(operator, 2);
    outline.add(last[4], last[5], line);
  }

  private void checkOpen(char operator) {
    if (outline == null) {
      throw xml.fault(line, operator + " in " + PLACE + " is not preceded by m; add it");
    }
  }

  private void checkNumbers(char operator, int count) {
    if (numbers != count) {
      throw xml.fault(
          line,
          operator
              + " in "
              + PLACE
              + " needs "
              + count
              + " numbers, not "
              + numbers
              + "; correct it");
    }
  }

  private void ellipse() {
    checkNumbers('e', 6);
    Affine disc = matrix.of(new Affine(last[0], last[1], last[2], last[3], last[4], last[5]));
    xml.checkFinite(disc.e(), disc.f(), line);
    shapes.addDisc(label, disc.e(), disc.f(), disc.scale(), line);
  }

  private void finish() {
    if (outline != null && isCurved) {
      shapes.leaveOut(LeftOut.CURVED);
    } else if (outline != null) {
      shapes.add(label, outline);
    }
    outline = null;
    isCurved = false;
  }
}
