package dct.io;

import dct.core.Progress;
import dct.core.degree.Flip;
import dct.core.degree.FlipList;
import dct.io.text.BadInputException;
import dct.io.text.Shown;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Flips in order: a file with a line {@code v0 v2 -> v1 v3} for each, the edge that is removed and
 * the one that takes its place. Blank lines and comments after {@code #} are skipped. Linear.
 *
 * <p>What was read keeps the lines, so that a flip which turns out to be impossible can be named.
 */
public final class FlipFile {
  private static final String VERTEX = "v([0-9]{1,9})";
  private static final Pattern FLIP =
      Pattern.compile(
          String.join("\\s+", VERTEX, VERTEX) + "\\s*->\\s*" + String.join("\\s+", VERTEX, VERTEX));
  private static final String HEAD = "# flips: the edge removed -> the edge made\n";
  private static final String FORM = "write the edge removed and the edge made, v0 v2 -> v1 v3";

  private final String name;
  private final FlipList list;
  private final int[] lines; // by flip

  private FlipFile(String name, FlipList list, int[] lines) {
    this.name = name;
    this.list = list;
    this.lines = lines;
  }

  /**
   * Reads the flips of a triangulation of n vertices.
   *
   * @throws BadInputException if the file cannot be read, a line is not of that form, a vertex does
   *     not exist, or there is no flip
   */
  public static FlipFile read(Path file, int n, Progress progress) {
    return PointFile.open(file, progress, (name, in) -> read(name, in, n));
  }

  /**
   * Reads the flips of a triangulation of n vertices from a stream.
   *
   * @param name what messages call it, "-" for standard input
   * @throws BadInputException if a line is not of that form, a vertex does not exist, or there is
   *     no flip
   */
  public static FlipFile read(String name, InputStream in, int n) throws IOException {
    BufferedReader reader = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
    List<Flip> flips = new ArrayList<>();
    int[] lines = new int[16];
    int line = 0;
    for (String text = reader.readLine(); text != null; text = reader.readLine()) {
      line++;
      String content = withoutComment(text);
      if (!content.isEmpty()) {
        lines = flips.size() == lines.length ? Arrays.copyOf(lines, 2 * lines.length) : lines;
        lines[flips.size()] = line;
        flips.add(flip(name, line, content, n));
      }
    }
    if (flips.isEmpty()) {
      throw new BadInputException(name, 0, "there is no flip in the file; " + FORM);
    }
    return new FlipFile(name, new FlipList(flips), lines);
  }

  private static String withoutComment(String text) {
    int comment = text.indexOf('#');
    return (comment < 0 ? text : text.substring(0, comment)).replace("\uFEFF", "").strip();
  }

  private static Flip flip(String name, int line, String content, int n) {
    Matcher matcher = FLIP.matcher(content);
    if (!matcher.matches()) {
      throw new BadInputException(
          name, line, "\"" + Shown.word(content) + "\" is no flip; " + FORM);
    }
    int[] corner = new int[4];
    for (int k = 0; k < corner.length; k++) {
      corner[k] = Integer.parseInt(matcher.group(k + 1));
      if (corner[k] >= n) {
        throw new BadInputException(
            name,
            line,
            String.format(
                Locale.ROOT,
                "there is no vertex v%d, the last one is v%d; apply the flips to the points that"
                    + " they were made for",
                corner[k],
                n - 1));
      }
    }
    if (Arrays.stream(corner).distinct().count() < corner.length) {
      throw new BadInputException(name, line, "a flip has four different vertices; " + FORM);
    }
    return new Flip(corner[0], corner[1], corner[2], corner[3]);
  }

  /** The flips. */
  public FlipList list() {
    return list;
  }

  /** The line of flip i, from 1 on. */
  public int line(int i) {
    return lines[i];
  }

  /**
   * What is to be said where not all flips could be carried out: the file and the line of the first
   * that could not, the cause and a cure.
   *
   * @param applied what came of carrying them out, stopped by a cause
   */
  public String refusal(FlipList.Applied applied) {
    int done = applied.result().flips();
    String before = ", or keep the " + done + (done == 1 ? " flip" : " flips") + " before";
    return new BadInputException(
            name,
            lines[done],
            applied.cause().orElseThrow()
                + " here; apply the flips to the triangulation that they were made for"
                + (done == 0 ? "" : before))
        .getMessage();
  }

  /**
   * Writes flips.
   *
   * @throws CannotWriteException if that failed; nothing is changed then
   */
  public static void write(Path file, FlipList list, Progress progress)
      throws CannotWriteException {
    byte[] bytes = text(list).getBytes(StandardCharsets.US_ASCII);
    AtomicFile.write(file, progress, out -> out.write(bytes));
  }

  /** The flips as text, a line each. */
  public static String text(FlipList list) {
    StringBuilder text = new StringBuilder(HEAD);
    for (Flip flip : list.flips()) {
      text.append('v').append(flip.u()).append(" v").append(flip.v()).append(" -> v");
      text.append(flip.x()).append(" v").append(flip.y()).append('\n');
    }
    return text.toString();
  }
}
