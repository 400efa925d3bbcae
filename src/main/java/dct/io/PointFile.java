package dct.io;

import dct.core.Decimals;
import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Files of points: the program's own text, or the {@code points} of its JSON, told by content.
 *
 * <p>Reading and writing take linear time.
 */
public final class PointFile {
  private static final int LOOK_AHEAD = 8192;

  private PointFile() {}

  /**
   * Reads the file that {@link FileNames#forOpening} leads to.
   *
   * @throws BadInputException if there is none, or it holds no points
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static PointDocument read(Path typed, Progress progress) {
    Path file = FileNames.forOpening(typed);
    PointDocument document = open(file, progress, PointFile::read);
    return FileNames.domain(file).map(document::declared).orElse(document);
  }

  /** Makes something of the stream of a file. */
  @FunctionalInterface
  interface StreamReader<T> {
    T read(String name, InputStream in) throws IOException;
  }

  /** Opens a file and says in one sentence why that failed. */
  static <T> T open(Path file, Progress progress, StreamReader<T> reader) {
    String name = file.toString();
    if (Files.isDirectory(file)) {
      throw new BadInputException(name, 0, "this is a folder; name a file in it");
    }
    if (!Files.exists(file)) {
      throw new BadInputException(name, 0, "there is no such file; check its name and folder");
    }
    try (InputStream in = Files.newInputStream(file)) {
      return reader.read(name, ProgressStreams.reading(in, Files.size(file), progress));
    } catch (AccessDeniedException e) {
      throw new BadInputException(name, 0, "the file may not be read; change its permissions");
    } catch (IOException e) {
      throw new BadInputException(
          name,
          0,
          "reading failed (" + e.getMessage() + "); check the disk or choose another file");
    }
  }

  /**
   * Reads a stream to its end.
   *
   * @param name what messages call it, "-" for standard input
   * @throws BadInputException if it holds no points
   */
  public static PointDocument read(String name, InputStream in) throws IOException {
    BufferedInputStream buffered = new BufferedInputStream(in, LOOK_AHEAD);
    return startsAsJson(buffered)
        ? PointDocument.of(JsonText.read(name, buffered))
        : VertexText.read(name, buffered);
  }

  /**
   * Whether the first character, white space and a byte-order mark left out, is a brace with no
   * number behind it.
   */
  private static boolean startsAsJson(BufferedInputStream in) throws IOException {
    in.mark(LOOK_AHEAD);
    byte[] head = in.readNBytes(LOOK_AHEAD);
    in.reset();
    int brace = afterSpace(head, 0);
    if (brace == head.length || head[brace] != '{') {
      return false;
    }
    int next = afterSpace(head, brace + 1);
    return next == head.length || "+-.0123456789".indexOf(head[next]) < 0;
  }

  private static int afterSpace(byte[] head, int from) {
    int i = from;
    while (i < head.length
        && (head[i] < 0 || ByteLines.isBlank(head[i]) || head[i] == '\n' || head[i] == '\r')) {
      i++;
    }
    return i;
  }

  /**
   * Writes points as text, whole or not at all.
   *
   * <p>Where the name does not say what the points are, the first line is a comment that does.
   *
   * @param file written as named; see {@link FileNames#forSaving}
   * @throws CannotWriteException if that failed; nothing is changed then
   */
  public static void write(Path file, Domain domain, Points points, Progress progress)
      throws CannotWriteException {
    String head = head(file, Optional.of(domain));
    AtomicFile.write(file, progress, out -> write(out, head, points, progress));
  }

  /** Writes the points of a document, and of what domain it is said to be, in the same way. */
  public static void write(Path file, PointDocument document, Progress progress)
      throws CannotWriteException {
    String head = head(file, document.declared());
    AtomicFile.write(file, progress, out -> write(out, head, document.points(), progress));
  }

  /** Writes points as text to a stream, behind a comment that says what they are. */
  public static void write(OutputStream out, Domain domain, Points points) throws IOException {
    write(out, kindLine(domain), points, Progress.NONE);
  }

  /** Writes the points of a document as text to a stream. */
  public static void write(OutputStream out, PointDocument document) throws IOException {
    String head = document.declared().map(PointFile::kindLine).orElse("");
    write(out, head, document.points(), Progress.NONE);
  }

  private static String head(Path file, Optional<Domain> domain) {
    return FileNames.domain(file).equals(domain) ? "" : domain.map(PointFile::kindLine).orElse("");
  }

  private static String kindLine(Domain domain) {
    return VertexText.kindLine(domain) + "\n";
  }

  private static void write(OutputStream out, String head, Points points, Progress progress)
      throws IOException {
    StringBuilder text = new StringBuilder(head);
    for (int i = 0; i < points.size(); i++) {
      Progress.tick(progress, i, points.size(), "Writing");
      Decimals.append(text, points.x(i));
      text.append(i == 0 && TextLayout.looksLikeCounts(points) ? ".0 " : " ");
      Decimals.append(text, points.y(i));
      text.append('\n');
      if (text.length() > 1 << 15) {
        flush(text, out);
      }
    }
    flush(text, out);
  }

  private static void flush(StringBuilder text, OutputStream out) throws IOException {
    out.write(text.toString().getBytes(StandardCharsets.US_ASCII));
    text.setLength(0);
  }
}
