package dct.bench;

import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import java.io.BufferedOutputStream;
import java.io.BufferedReader;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/**
 * CGAL's constrained Delaunay triangulation of a region, in a process of its own that is asked
 * round by round. It is the program of {@code src/jmh/native/cdt.cpp}, compiled by
 *
 * <pre>
 * g++ -O3 -DNDEBUG -march=native -o cdt src/jmh/native/cdt.cpp -lgmp -lmpfr
 * </pre>
 *
 * and named as an argument; where it is not named, nothing is asked.
 */
final class CgalProcess implements AutoCloseable {
  private final Optional<Path> file; // what it reads; nothing if it is not asked
  private final Process process;
  private final BufferedReader answers;
  private final Writer questions;
  private final int triangles;

  private CgalProcess() {
    file = Optional.empty();
    process = null;
    answers = null;
    questions = null;
    triangles = 0;
  }

  private CgalProcess(String program, Path file, int triangles) throws IOException {
    this.file = Optional.of(file);
    this.triangles = triangles;
    process =
        new ProcessBuilder(program, file.toString())
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    answers = process.inputReader(StandardCharsets.US_ASCII);
    questions = process.outputWriter(StandardCharsets.US_ASCII);
  }

  /**
   * The process for a region.
   *
   * @param program its name, if it shall be asked
   * @param all the number of triangles in the hull of all vertices
   */
  static CgalProcess of(Optional<String> program, Region region, int all) {
    if (program.isEmpty()) {
      return new CgalProcess();
    }
    boolean isFixed = region.rings().fixedCount() > 0;
    try {
      Path file = Files.createTempFile("region", ".bin");
      write(file, region);
      return new CgalProcess(program.get(), file, isFixed ? all : region.triangles());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void write(Path file, Region region) throws IOException {
    Rings rings = region.rings();
    Points points = region.points();
    try (DataOutputStream out =
        new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(file)))) {
      number(out, points.size());
      number(out, rings.ringVertices());
      number(out, rings.fixedCount());
      for (int v = 0; v < points.size(); v++) {
        number(out, Double.doubleToRawLongBits(points.x(v)));
        number(out, Double.doubleToRawLongBits(points.y(v)));
      }
      for (int edge = 0; edge < points.size() + rings.fixedCount(); edge++) {
        if (edge >= points.size() || rings.isOnRing(edge)) {
          number(out, rings.from(edge));
          number(out, rings.to(edge));
        }
      }
    }
  }

  private static void number(DataOutputStream out, long value) throws IOException {
    out.writeLong(Long.reverseBytes(value));
  }

  /** Triangulates once; the time that it took, which is no number if it is not asked. */
  double millis() {
    if (file.isEmpty()) {
      return Double.NaN;
    }
    try {
      questions.write("once more\n");
      questions.flush();
      String[] answer = answers.readLine().split(" ");
      if (Integer.parseInt(answer[1]) != triangles) {
        throw new IllegalStateException(answer[1] + " triangles, not " + triangles);
      }
      return Double.parseDouble(answer[0]);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() {
    if (file.isPresent()) {
      process.destroy();
      try {
        Files.deleteIfExists(file.get());
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }
}
