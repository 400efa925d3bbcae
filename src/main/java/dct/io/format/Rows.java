package dct.io.format;

import dct.core.Decimals;
import dct.io.text.BadInputException;
import dct.io.text.ByteLines;
import dct.io.text.Shown;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The lines of a file as words parted by blanks, without comments of {@code #} and lines that are
 * empty then. A line longer than {@value ByteLines#LONGEST} bytes is refused.
 */
public final class Rows {
  private final String name;
  private final ByteLines lines;
  private List<String> words = List.of();

  /** The rows of an input, before the first of them. */
  public Rows(Input input) throws IOException {
    name = input.name();
    lines = new ByteLines(input.in());
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
      words = split();
      if (lines.isCut()) {
        throw fault("the line is longer than " + ByteLines.LONGEST + " bytes; break it");
      }
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

  private List<String> split() {
    List<String> found = new ArrayList<>();
    byte[] bytes = lines.bytes();
    int i = lines.start();
    while (i < lines.end() && bytes[i] != '#') {
      int from = i;
      while (i < lines.end() && bytes[i] != '#' && !ByteLines.isBlank(bytes[i])) {
        i++;
      }
      if (i > from) {
        found.add(new String(bytes, from, i - from, StandardCharsets.UTF_8));
      } else {
        i++;
      }
    }
    return found;
  }

  /** The words of the row. */
  public List<String> words() {
    return words;
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
