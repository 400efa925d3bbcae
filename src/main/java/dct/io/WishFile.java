package dct.io;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.io.text.BadInputException;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/**
 * Wished parities: a file with a line {@code v even|odd|any} for each vertex that shall not be
 * even. Blank lines and comments after {@code #} are skipped; of two lines for one vertex the last
 * counts.
 */
public final class WishFile {
  private static final String FORM = "write a vertex number and even, odd or any";

  private WishFile() {}

  /**
   * Reads the wishes for n vertices.
   *
   * @throws BadInputException if the file cannot be read, a line is not of that form, or a vertex
   *     does not exist
   */
  public static ParityGoal read(Path file, int n, Progress progress) {
    return PointFile.open(file, progress, (name, in) -> read(name, in, n));
  }

  /**
   * Writes the wishes that are not even.
   *
   * @throws CannotWriteException if that failed; nothing is changed then
   */
  public static void write(Path file, ParityGoal goal, Progress progress)
      throws CannotWriteException {
    StringBuilder lines = new StringBuilder();
    for (int v = 0; v < goal.size(); v++) {
      if (goal.wish(v) != Wish.EVEN) {
        lines.append(v).append(' ').append(word(goal.wish(v))).append('\n');
      }
    }
    byte[] bytes = lines.toString().getBytes(StandardCharsets.UTF_8);
    AtomicFile.write(file, progress, out -> out.write(bytes));
  }

  /**
   * Reads the wishes for n vertices from a stream.
   *
   * @param name what messages call it, "-" for standard input
   * @throws BadInputException if a line is not of that form, or a vertex does not exist
   */
  public static ParityGoal read(String name, InputStream in, int n) throws IOException {
    Wish[] wishes = new Wish[n];
    Arrays.fill(wishes, Wish.EVEN);
    BufferedReader reader = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
    int line = 0;
    for (String text = reader.readLine(); text != null; text = reader.readLine()) {
      line++;
      String content = withoutComment(text);
      if (!content.isEmpty()) {
        readLine(name, line, content, wishes);
      }
    }
    return ParityGoal.of(wishes);
  }

  private static String withoutComment(String text) {
    int comment = text.indexOf('#');
    return (comment < 0 ? text : text.substring(0, comment)).replace("\uFEFF", "").strip();
  }

  private static void readLine(String name, int line, String content, Wish[] wishes) {
    int gap = 0;
    while (gap < content.length() && Character.isDigit(content.charAt(gap))) {
      gap++;
    }
    Optional<Wish> wish = wish(content.substring(gap).strip());
    if (gap == 0 || gap > 9 || wish.isEmpty()) {
      throw new BadInputException(name, line, "this is no wish for a vertex; " + FORM);
    }
    int vertex = Integer.parseInt(content.substring(0, gap));
    if (vertex >= wishes.length) {
      throw new BadInputException(
          name,
          line,
          String.format(
              Locale.ROOT,
              "there is no vertex %d, the last one is %d; correct the number",
              vertex,
              wishes.length - 1));
    }
    wishes[vertex] = wish.get();
  }

  private static Optional<Wish> wish(String word) {
    return Arrays.stream(Wish.values()).filter(wish -> word(wish).equals(word)).findFirst();
  }

  private static String word(Wish wish) {
    return wish.name().toLowerCase(Locale.ROOT);
  }
}
