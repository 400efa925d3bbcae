package dct.io.format.plain;

import dct.io.format.Columns;
import dct.io.format.PointColumns;
import dct.io.format.UnclearColumns;
import dct.io.text.BadInputException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The numbers of a text, row by row, each row as wide as the first; and which columns are x and y.
 *
 * <p>Two columns are x and y, unless a header row says otherwise. With more, a header row tells, or
 * the first column numbers the rows from 0 or 1 on; three columns without either are x, y and z.
 * Where two of these can be meant, the text is refused.
 */
final class Table {
  private static final int WIDEST = 100;

  private final String name;
  private int width; // 0 before the first row
  private double[] values = new double[32];
  private int[] lines = new int[16];
  private int size;
  private boolean startsWhole = true; // the first column is written in whole numbers
  private boolean restWhole = true; // and so are all others
  private Optional<HeaderRow> header = Optional.empty();

  /** An empty table of a text that messages call by this name. */
  Table(String name) {
    this.name = name;
  }

  int size() {
    return size;
  }

  /** How many columns there are; 0 before the first row. */
  int width() {
    return width;
  }

  boolean hasHeader() {
    return header.isPresent();
  }

  void header(HeaderRow row) {
    header = Optional.of(row);
  }

  /** Adds a row of two numbers. */
  void add(double x, double y, int line) {
    require(2, line);
    int at = room(line);
    values[at] = x;
    values[at + 1] = y;
  }

  /** Adds a row of a line, and hears which of its numbers are written as whole numbers. */
  void add(NumberScan rows, int row, int line) {
    require(rows.size(row), line);
    int at = room(line);
    for (int c = 0; c < width; c++) {
      values[at + c] = rows.value(row, c);
      boolean whole = rows.isWhole(row, c);
      startsWhole &= whole || c > 0;
      restWhole &= whole || c == 0;
    }
  }

  private void require(int numbers, int line) {
    if (width == 0) {
      width = Math.min(numbers, WIDEST + 1);
    }
    if (numbers != width) {
      String fault =
          String.format(
              Locale.ROOT,
              "there are %d numbers here, but %d in line %d; write one vertex a line, as two"
                  + " numbers x y",
              numbers,
              width,
              lines[0]);
      throw new BadInputException(name, line, fault);
    }
  }

  private int room(int line) {
    int at = Math.multiplyExact(size, width);
    if (at + width > values.length) {
      values = Arrays.copyOf(values, Math.multiplyExact(2, at + width));
    }
    if (size == lines.length) {
      lines = Arrays.copyOf(lines, Math.multiplyExact(2, size));
    }
    lines[size++] = line;
    return at;
  }

  /**
   * The points: the rows' x and y.
   *
   * @param asked which columns are meant, if that was said
   * @param notes hears what is left out
   * @throws BadInputException if that cannot be told
   */
  PointColumns points(Optional<Columns.Pair> asked, List<String> notes) {
    if (asked.isEmpty() && header.isEmpty() && size == 1 && width >= 6 && width % 2 == 0) {
      notes.add("All numbers stand in one line and are read as x and y in turn");
      return pairs();
    }
    Columns.Pair xy = asked.orElseGet(() -> told(notes));
    if (xy.x() > width || xy.y() > width) {
      throw unclear("there are only " + width + " columns; give --columns with two of them");
    }
    PointColumns points = new PointColumns();
    for (int row = 0; row < size; row++) {
      int at = row * width - 1;
      points.add(values[at + xy.x()], values[at + xy.y()], lines[row]);
    }
    return points;
  }

  /** All numbers stand in one line, x and y in turn. */
  private PointColumns pairs() {
    PointColumns points = new PointColumns();
    for (int i = 0; i < width; i += 2) {
      points.add(values[i], values[i + 1], lines[0]);
    }
    return points;
  }

  private Columns.Pair told(List<String> notes) {
    Optional<Columns.Pair> named = header.flatMap(HeaderRow::xy);
    if (named.isPresent()) {
      notes.add(header.get().note(named.get()));
      return named.get();
    }
    header.ifPresent(row -> notes.add("The header row is left out"));
    boolean isNumbered = width > 2 && startsWhole && countsRows();
    return switch (width) {
      case 2 -> new Columns.Pair(1, 2);
      case 3 -> isNumbered ? behindNumbers(notes) : beforeHeight(1, notes);
      case 4 -> {
        if (!isNumbered) {
          throw ambiguous("of the 4 columns any two can be x and y");
        }
        notes.add("The first column numbers the rows and is left out");
        yield beforeHeight(2, notes);
      }
      default -> throw ambiguous("of the " + width + " columns any two can be x and y");
    };
  }

  private Columns.Pair behindNumbers(List<String> notes) {
    if (restWhole) {
      throw ambiguous(
          "the three columns can be a number of the row, x and y (--columns 2,3), or x, y and z"
              + " (--columns 1,2)");
    }
    notes.add("The first column numbers the rows and is left out");
    return new Columns.Pair(2, 3);
  }

  private static Columns.Pair beforeHeight(int x, List<String> notes) {
    notes.add("The column of z behind x and y is left out");
    return new Columns.Pair(x, x + 1);
  }

  private UnclearColumns ambiguous(String what) {
    return unclear(what + "; keep those of x and y, or give --columns X,Y");
  }

  private UnclearColumns unclear(String fault) {
    List<double[]> rows = new ArrayList<>();
    for (int row = 0; row < Math.min(size, UnclearColumns.ROWS); row++) {
      rows.add(Arrays.copyOfRange(values, row * width, (row + 1) * width));
    }
    return new UnclearColumns(name, lines[0], fault, rows, Columns.TOLD_BY_CONTENT);
  }

  /** Whether the first column is 0, 1, 2, … or 1, 2, 3, …, over two rows at least. */
  private boolean countsRows() {
    double first = values[0];
    for (int row = 0; row < size; row++) {
      if (values[row * width] != first + row) {
        return false;
      }
    }
    return size > 1 && (first == 0 || first == 1);
  }
}
