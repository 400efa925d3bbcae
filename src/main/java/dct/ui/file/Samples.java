package dct.ui.file;

import dct.core.triangulate.Domain;
import dct.io.FileNames;
import dct.io.PointDocument;
import dct.io.PointFile;
import dct.io.format.Choice;
import dct.ui.document.Document;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;

/** The files that come with the program, read from its classes or its jar. */
public final class Samples {
  private static final String FOLDER = "/samples/";
  private static final String INDEX = "index.txt";

  private Samples() {}

  /** The names of the samples of one application, in the order of the index. */
  public static List<String> names(Domain domain) {
    return names().stream().filter(name -> domain(name) == domain).toList();
  }

  private static Domain domain(String name) {
    return FileNames.domain(Path.of(name)).orElse(Domain.POLYGON);
  }

  /**
   * A name for a menu: "Figure 3.9 convex pieces" for figure_3_09_convex_pieces_polygonbased.txt.
   */
  public static String title(String name) {
    String words =
        name.replaceFirst("_(polygonbased|pointbased|region)\\.txt$", "")
            .replaceFirst("_(\\d+)_0*(\\d+)", "_$1.$2")
            .replace('_', ' ');
    return Character.toUpperCase(words.charAt(0)) + words.substring(1);
  }

  /** The names of all samples, in the order of the index; none if there is no index. */
  public static List<String> names() {
    try (InputStream in = Samples.class.getResourceAsStream(FOLDER + INDEX)) {
      if (in == null) {
        return List.of();
      }
      String index = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      return index.lines().map(String::strip).filter(Samples::isName).toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static boolean isName(String line) {
    return !line.isEmpty() && !line.startsWith("#");
  }

  /** Reads a sample. */
  public static Document read(String name) {
    try (InputStream in = Samples.class.getResourceAsStream(FOLDER + name)) {
      if (in == null) {
        throw new IllegalStateException("the program lacks its sample " + name);
      }
      PointDocument read = PointFile.read(name, in, Choice.NONE.otherwise(domain(name)));
      return read.rings()
          .map(Document::of)
          .orElseGet(() -> new Document(domain(name), read.points()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
