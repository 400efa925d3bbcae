package dct.io.format;

import dct.core.Decimals;
import dct.io.text.BadInputException;
import dct.io.text.ByteLines;
import dct.io.text.Shown;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.AbstractList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The lines of a file as words parted by blanks, without comments of {@code #} and lines that are
 * empty then. A line longer than 16 MiB is refused: a face of some two million corners is as long.
 */
public final class Rows {
  private static final int LONGEST = 1 << 24;

  private final String name;
  private final ByteLines lines;
  private final List<String> words = new Words();
  private int[] places = new int[16]; // of each word in the line: its start, and the end behind it
  private int size; // how many words there are

  /** The rows of an input, before the first of them. */
  public Rows(Input input) throws IOException {
    name = input.name();
    lines = new ByteLines(input.in(), LONGEST);
  }

  /** The lines of a file's start that hold more than a comment. */
  public static Stream<String> of(Head head) {
    return head.text().lines().map(Rows::withoutComment).filter(line -> !line.isEmpty());
  }

  /** Whether the first of these lines match these patterns, each as a whole. */
  public static boolean startsWith(Head head, Pattern... patterns) {
    List<String> rows = of(head).limit(patterns.length).toList();
    return rows.size() == patterns.length
        && IntStream.range(0, patterns.length)
            .allMatch(i -> patterns[i].matcher(rows.get(i)).matches());
  }

  private static String withoutComment(String line) {
    int comment = line.indexOf('#');
    return (comment < 0 ? line : line.substring(0, comment)).strip();
  }

  /** Goes to the next row, if there is one. */
  public boolean next() throws IOException {
    while (lines.next()) {
      if (lines.isCut()) {
        throw fault("the line is longer than 16 MiB; break it");
      }
      split();
      if (!words.isEmpty()) {
        return true;
      }
    }
    return false;
  }

  /**
   * Goes to the next row.
   *
   * @param done how many of the expected things were read
   * @param expected how many the file says there are
   * @param things what they are called, as {@code vertices}
   * @throws BadInputException if the file has ended
   */
  public void next(int done, int expected, String things) throws IOException {
    if (!next()) {
      throw fault(
          "the file ends after "
              + done
              + " of "
              + expected
              + " "
              + things
              + "; correct the count, or fetch the file again if it was cut off");
    }
  }

  /**
   * Goes to each of so many rows, behind which the file ends.
   *
   * @param thing what each of them is, as {@code triangle}
   * @param action what to do at each
   * @throws BadInputException if there are fewer or more
   */
  public void rest(int count, String thing, Runnable action) throws IOException {
    for (int i = 0; i < count; i++) {
      next(i, count, thing + "s");
      action.run();
    }
    end("its last " + thing, "count");
  }

  /**
   * Reads so many points of the plane, one a row.
   *
   * @throws BadInputException if there are fewer, or a row has not two numbers
   */
  public PointColumns points(int count) throws IOException {
    PointColumns points = new PointColumns();
    for (int i = 0; i < count; i++) {
      next(i, count, "points");
      if (size != 2) {
        throw fault("there are " + size + " numbers, not 2; write one point a line");
      }
      points.add(number(0), number(1), line());
    }
    return points;
  }

  /**
   * Sees that there is no further row.
   *
   * @param last what the present row is, as {@code its last triangle}
   * @param wrong what is to be corrected otherwise
   */
  public void end(String last, String wrong) throws IOException {
    if (next()) {
      throw fault("the file goes on behind " + last + "; correct the " + wrong);
    }
  }

  private void split() {
    size = 0;
    byte[] bytes = lines.bytes();
    int i = lines.start();
    while (i < lines.end() && bytes[i] != '#') {
      int from = i;
      while (i < lines.end() && bytes[i] != '#' && !ByteLines.isBlank(bytes[i])) {
        i++;
      }
      if (i > from) {
        place(from, i);
      } else {
        i++;
      }
    }
  }

  private void place(int from, int to) {
    if (2 * size == places.length) {
      places = Arrays.copyOf(places, Math.multiplyExact(2, places.length));
    }
    places[2 * size] = from;
    places[2 * size + 1] = to;
    size++;
  }

  /** The words of the row, until the next one. */
  public List<String> words() {
    return words;
  }

  /** Strings that are made when they are asked for, since a row can have millions of words. */
  private final class Words extends AbstractList<String> {
    @Override
    public String get(int i) {
      int from = places[2 * Objects.checkIndex(i, size)];
      return new String(lines.bytes(), from, places[2 * i + 1] - from, StandardCharsets.UTF_8);
    }

    @Override
    public int size() {
      return size;
    }
  }

  /** The line of the row, from 1 on; at the end of the file its last line. */
  public int line() {
    return Math.max(1, lines.number());
  }

  /**
   * A word as a coordinate.
   *
   * @throws BadInputException if there is no such word, or it is no finite number
   */
  public double number(int i) {
    double number = Decimals.parse(word(i));
    if (!Double.isFinite(number)) {
      throw fault("\"" + Shown.word(word(i)) + "\" is not a finite number; correct it");
    }
    return number;
  }

  /**
   * A word as a whole number of at most nine digits; it may be negative.
   *
   * @throws BadInputException if there is no such word, or it is something else
   */
  public int whole(int i) {
    return whole(word(i));
  }

  /** The same of a part of a word. */
  public int whole(String word) {
    if (!word.matches("[-+]?[0-9]{1,9}")) {
      throw fault("\"" + Shown.word(word) + "\" is not a whole number below 10⁹; correct it");
    }
    return Integer.parseInt(word);
  }

  /**
   * A word as a count.
   *
   * @throws BadInputException if it is no whole number from 0 on
   */
  public int count(int i) {
    int count = whole(i);
    if (count < 0) {
      throw fault("a count is " + count + "; correct it");
    }
    return count;
  }

  private String word(int i) {
    if (i >= words.size()) {
      throw fault(
          "a number is missing, the line has only " + words.size() + "; correct or remove it");
    }
    return words.get(i);
  }

  /** What is wrong in this row. */
  public BadInputException fault(String fault) {
    return new BadInputException(name, line(), fault);
  }
}
