package dct.io;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.triangulate.Domain;
import dct.io.format.Choice;
import dct.io.format.Columns;
import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Shapes;
import dct.io.format.TextOut;
import dct.io.format.plain.TextLayout;
import dct.io.format.plain.VertexText;
import dct.io.text.BadInputException;
import dct.io.text.PlainText;
import dct.problem.verify.Claims;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * Files of points, in any of the {@link Formats} or as the program's own JSON, told by content.
 *
 * <p>Reading and writing take linear time.
 */
public final class PointFile {
  private PointFile() {}

  /**
   * Reads the file that {@link FileNames#forOpening} leads to.
   *
   * @throws dct.io.format.SeveralShapes if it holds several shapes and none was chosen
   * @throws BadInputException if there is no such file, or it holds no points
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static PointDocument read(Path typed, Choice choice, Progress progress) {
    Path file = FileNames.forOpening(typed);
    Choice named =
        choice.as().isPresent() ? choice : FileNames.domain(file).map(choice::as).orElse(choice);
    return open(file, progress, (name, in) -> read(name, in, Optional.of(file), named, progress));
  }

  /** The same where name and content tell what the points are. */
  public static PointDocument read(Path typed, Progress progress) {
    return read(typed, Choice.NONE, progress);
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
   * @throws dct.io.format.SeveralShapes if it holds several shapes and none was chosen
   * @throws BadInputException if it holds no points
   */
  public static PointDocument read(String name, InputStream in, Choice choice) throws IOException {
    return read(name, in, Optional.empty(), choice, Progress.NONE);
  }

  /**
   * All shapes of a file, without choosing one.
   *
   * @throws BadInputException if there is no such file, or it holds no points
   */
  public static Shapes shapes(Path typed, Columns columns, Progress progress) {
    Path file = FileNames.forOpening(typed);
    return open(file, progress, (name, in) -> shapes(name, in, Optional.of(file), columns));
  }

  /** The same for a stream. */
  public static Shapes shapes(String name, InputStream in, Columns columns) throws IOException {
    return shapes(name, in, Optional.empty(), columns);
  }

  private static Shapes shapes(String name, InputStream in, Optional<Path> file, Columns columns)
      throws IOException {
    return recognized(name, in, file, columns, OwnJson::shapes, (format, shapes) -> shapes);
  }

  /** Tells the format of a text, reads it, and makes something of what it holds. */
  static <T> T recognized(
      String name,
      InputStream in,
      Optional<Path> file,
      Columns columns,
      Function<Claims, T> own,
      BiFunction<Format, Shapes, T> foreign)
      throws IOException {
    BufferedInputStream text = new BufferedInputStream(PlainText.of(name, in), Head.LENGTH);
    Optional<Format> format = Formats.of(Head.of(text));
    if (format.isEmpty()) {
      return own.apply(JsonText.read(name, text));
    }
    Shapes shapes = format.get().read(new Input(name, text, file, columns));
    return foreign.apply(format.get(), shapes);
  }

  /** The same where the content tells what the points are. */
  public static PointDocument read(String name, InputStream in) throws IOException {
    return read(name, in, Choice.NONE);
  }

  private static PointDocument read(
      String name, InputStream in, Optional<Path> file, Choice choice, Progress progress)
      throws IOException {
    return recognized(
        name,
        in,
        file,
        choice.columns(),
        claims -> OwnJson.document(claims, choice, progress),
        (format, shapes) -> ChosenShape.of(name, shapes, format.yUp(), choice, progress));
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
    AtomicFile.write(
        file,
        progress,
        out -> {
          if (document.rings().isPresent()) {
            RegionText.write(out, document.rings().get(), progress);
          } else {
            write(out, head, document.points(), progress);
          }
        });
  }

  /** Writes a region as text, whole or not at all. */
  public static void write(Path file, Rings rings, Progress progress) throws CannotWriteException {
    AtomicFile.write(file, progress, out -> RegionText.write(out, rings, progress));
  }

  /** Writes points as text to a stream, behind a comment that says what they are. */
  public static void write(OutputStream out, Domain domain, Points points) throws IOException {
    write(out, kindLine(domain), points, Progress.NONE);
  }

  /** Writes the points of a document as text to a stream. */
  public static void write(OutputStream out, PointDocument document) throws IOException {
    if (document.rings().isPresent()) {
      RegionText.write(out, document.rings().get(), Progress.NONE);
      return;
    }
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
    TextOut text = new TextOut(out, progress).add(head);
    for (int i = 0; i < points.size(); i++) {
      text.tick(i, points.size());
      text.add(points.x(i));
      text.add(i == 0 && TextLayout.looksLikeCounts(points) ? ".0 " : " ");
      text.add(points.y(i)).add("\n");
    }
    text.flush();
  }
}
