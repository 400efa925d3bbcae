package dct.experiment.study;

import java.util.List;
import java.util.Locale;
import java.util.SortedSet;
import java.util.TreeSet;

/** Numbers of vertices as the user lists them: {@code 50,100} or {@code 50-500:50}. */
public final class SizeList {
  private static final int FEWEST = 3; // vertices of a triangle

  private SizeList() {}

  /**
   * The numbers in ascending order, each once.
   *
   * @param most the largest that is allowed
   * @throws IllegalArgumentException if the text is no such list; the message is for a person
   */
  public static List<Integer> parse(String text, int most) {
    SortedSet<Integer> sizes = new TreeSet<>();
    for (String range : text.split(",", -1)) {
      addRange(sizes, range, most);
    }
    return List.copyOf(sizes);
  }

  private static void addRange(SortedSet<Integer> sizes, String text, int most) {
    boolean isRange = text.matches("\\d+-\\d+:\\d{1,9}");
    if (!isRange && !text.matches("\\d+")) {
      throw new IllegalArgumentException(
          String.format(Locale.ROOT, "%s is no number and no FROM-TO:STEP", text));
    }
    String[] parts = text.split("[-:]", -1);
    int from = size(parts[0], most);
    int to = isRange ? size(parts[1], most) : from;
    int step = isRange ? Integer.parseInt(parts[2]) : 1;
    if (step < 1 || to < from) {
      throw new IllegalArgumentException(
          String.format(Locale.ROOT, "%s has no numbers in it", text));
    }
    for (long n = from; n <= to; n += step) {
      sizes.add((int) n);
    }
  }

  private static int size(String digits, int most) {
    long n = digits.length() > 10 ? Long.MAX_VALUE : Long.parseLong(digits);
    if (n < FEWEST || n > most) {
      throw new IllegalArgumentException(
          String.format(Locale.ROOT, "%s is not from %d to %d", digits, FEWEST, most));
    }
    return (int) n;
  }
}
