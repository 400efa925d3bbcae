package dct.testing;

import dct.core.geometry.Points;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;

/** Figures from files: the project's samples, and the shared data where they are at hand. */
public final class SharedData {
  private static final int PARENTS = 3;

  private SharedData() {}

  /**
   * The text files of a folder of {@code ../shared/data}, looked for from the project's root
   * upwards; the calling test is skipped, saying so, where there is none.
   */
  public static List<Path> files(String folder) {
    Optional<Path> found = find(Path.of("shared", "data", folder));
    Assumptions.assumeTrue(
        found.isPresent(), () -> "skipped: no folder ../shared/data/" + folder + " here");
    return textFiles(found.get());
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

  private static Optional<Path> find(Path relative) {
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
