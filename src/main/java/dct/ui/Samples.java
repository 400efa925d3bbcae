package dct.ui;

import dct.core.triangulate.Domain;
import dct.io.FileNames;
import dct.io.PointFile;
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

  /** Their names, in the order of the index; none if there is no index. */
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
      Domain domain = FileNames.domain(Path.of(name)).orElse(Domain.POLYGON);
      return new Document(domain, PointFile.read(name, in).points());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
