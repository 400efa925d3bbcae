package dct.testing;

import dct.core.geometry.Points;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Test data: the project's samples and tables, and public files where they are at hand, for {@link
 * ForeignDataTest}.
 */
public final class SharedData {
  private static final int PARENTS = 3;

  private SharedData() {}

  /** The text files of a folder of {@code ../shared/data}. */
  public static List<Path> files(String folder) {
    return textFiles(folder().orElseThrow().resolve(folder));
  }

  /**
   * The cells of each row of a table in {@code ../shared/data}, parted by tabs, without comments
   * and header.
   */
  public static List<String[]> sharedTable(String name) {
    try (Stream<String> lines = Files.lines(folder().orElseThrow().resolve(name))) {
      return lines
          .filter(line -> !line.startsWith("#"))
          .skip(1)
          .map(line -> line.split("\t", -1))
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * The cells of each row of a table in {@code src/test/resources/dct/testing}, its comments and
   * its header left out.
   */
  public static List<String[]> table(String name, String separator) {
    return lines(name).skip(1).map(line -> line.split(separator, -1)).toList();
  }

  /** The lines of a text in {@code src/test/resources/dct/testing}, its comments left out. */
  public static Stream<String> lines(String name) {
    try (InputStream in = SharedData.class.getResourceAsStream(name)) {
      String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      return text.lines().filter(line -> !line.startsWith("#"));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * The project's samples of one kind, {@code polygonbased} or {@code pointbased}; a test of them
   * fails where they are missing.
   */
  public static List<Path> samples(String kind) {
    return textFiles(Path.of("samples")).stream()
        .filter(file -> file.toString().endsWith("_" + kind + ".txt"))
        .toList();
  }

  /** The folder {@code ../shared/data}, looked for from the project's root upwards. */
  static Optional<Path> folder() {
    Path relative = Path.of("shared", "data");
    Path from = Path.of("").toAbsolutePath();
    for (int up = 0; up < PARENTS && from.getParent() != null; up++) {
      from = from.getParent();
      if (Files.isDirectory(from.resolve(relative))) {
        return Optional.of(from.resolve(relative));
      }
    }
    return Optional.empty();
  }

  private static List<Path> textFiles(Path folder) {
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(file -> file.toString().endsWith(".txt")).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The points of a file with a vertex {@code x y} a line and comments after {@code #}. */
  public static Points read(Path file) {
    try (Stream<String> lines = Files.lines(file)) {
      return Points.ofPairs(
          lines
              .map(line -> line.replaceFirst("#.*", "").strip())
              .filter(line -> !line.isEmpty())
              .flatMap(line -> Stream.of(line.split("[\\s,;]+")))
              .mapToDouble(Double::parseDouble)
              .toArray());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
