package dct.io;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.format.Columns;
import dct.io.format.Drawing;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.text.BadInputException;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.io.ParseException;
import org.locationtech.jts.io.WKTReader;

/**
 * Files of every format that are cut, mixed and filled with what no one expects: each is read or
 * refused in one sentence, and the readers never fail otherwise. The name of a run tells its seed.
 */
class DamagedFilesTest {
  private static final int ROUNDS = 2500;
  private static final int LONGEST = 8000;
  private static final Path CASES = Path.of("src/test/resources/cases");
  private static final String[] WORDS = {
    "NaN",
    "-Inf",
    "1e400",
    "-1",
    "-0",
    "1e-400",
    "1e-99999999999",
    "0",
    "1",
    "3",
    "1000000000",
    "2147483648",
    "99999999999999999999",
    "0x10",
    "1,5",
    "1e",
    ".",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ";",
    ":",
    "\"",
    "'",
    "#",
    "/",
    "<",
    ">",
    "&#0;",
    "\0",
    "\r",
    "\r\n",
    "\n\n",
    "\t",
    "\uFEFF",
    "\u2212",
    "\u00A0",
    "\u202E",
    "EMPTY",
    "POINT",
    "GEOMETRYCOLLECTION(",
    "null",
    "true",
    "{}",
    "[]",
    "\"x\"",
    "v",
    "f",
    "OFF",
    "DIMENSION : 3",
    "EOF",
    "<g>",
    "</g>",
    "scale(0)",
    "matrix(1e300 0 0 1e300 0 0)",
    "hole",
    "# kind: points",
    "1e308",
    "4.9e-324",
    "1/0",
    "1.0D+05"
  };

  /** A file and what it is called. */
  private static final class Sample {
    private final String name;
    private final byte[] bytes;

    Sample(String name, byte[] bytes) {
      this.name = name;
      this.bytes = bytes;
    }
  }

  private static List<Sample> samples() throws IOException {
    List<Sample> samples = new ArrayList<>();
    try (Stream<Path> files = Files.list(CASES)) {
      for (Path file : files.sorted().toList()) {
        samples.add(new Sample(file.getFileName().toString(), Files.readAllBytes(file)));
      }
    }
    Points points = Points.ofPairs(0, 0, 9, 1, 12, 7, 5, 3, 1, 8);
    for (Domain domain : Domain.applications()) {
      Instance instance = Instance.of(domain, "a", points, Progress.NONE);
      Method method = domain == Domain.SITES ? Method.DELAUNAY : Method.MONOTONE;
      Drawing drawing = Drawing.of(Solution.of(instance, method, Progress.NONE));
      for (FileEnding ending : DataFile.endings()) {
        if (domain == Domain.SITES || !ending.dotted().contains("json")) {
          ByteArrayOutputStream out = new ByteArrayOutputStream();
          DataFile.write(out, ending, drawing, Progress.NONE);
          samples.add(new Sample(domain + ending.dotted(), out.toByteArray()));
        }
      }
    }
    samples.removeIf(sample -> sample.bytes.length > LONGEST);
    return samples;
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void are_read_or_refused_in_a_sentence(long seed) throws IOException {
    List<Sample> samples = samples();
    Random random = new Random(seed);
    for (int round = 0; round < ROUNDS; round++) {
      Sample sample = samples.get(random.nextInt(samples.size()));
      byte[] damaged = sample.bytes;
      for (int i = random.nextInt(3); i >= 0; i--) {
        damaged = damaged(damaged, samples.get(random.nextInt(samples.size())).bytes, random);
      }
      check(damaged, sample.name + ", seed " + seed + ", round " + round);
    }
  }

  private static byte[] damaged(byte[] file, byte[] other, Random random) {
    int from = random.nextInt(file.length + 1);
    int to = Math.min(file.length, from + random.nextInt(20));
    byte[] word = WORDS[random.nextInt(WORDS.length)].getBytes(StandardCharsets.UTF_8);
    return switch (random.nextInt(7)) {
      case 0 -> Arrays.copyOf(file, from);
      case 1 -> replaced(file, from, from, word);
      case 2 -> replaced(file, from, wordEnd(file, from), word);
      case 3 -> replaced(file, from, to, new byte[] {(byte) random.nextInt(256)});
      case 4 -> replaced(file, from, from, repeated(word, 1 << random.nextInt(13)));
      case 5 -> replaced(file, from, from, Arrays.copyOfRange(file, from, to));
      default ->
          replaced(
              file,
              from,
              file.length,
              Arrays.copyOfRange(other, random.nextInt(other.length + 1), other.length));
    };
  }

  private static byte[] replaced(byte[] file, int from, int to, byte[] by) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.write(file, 0, from);
    out.writeBytes(by);
    out.write(file, to, file.length - to);
    return out.toByteArray();
  }

  private static int wordEnd(byte[] file, int from) {
    int end = from;
    while (end < file.length && (file[end] == '.' || Character.isLetterOrDigit(file[end]))) {
      end++;
    }
    return end;
  }

  private static byte[] repeated(byte[] word, int length) {
    byte[] all = new byte[length];
    for (int i = 0; i < length; i++) {
      all[i] = word[i % word.length];
    }
    return all;
  }

  private static void check(byte[] file, String which) throws IOException {
    try {
      Shapes shapes =
          PointFile.shapes("in", new ByteArrayInputStream(file), Columns.TOLD_BY_CONTENT);
      assertThat(shapes.shapes()).as(which).isNotEmpty();
      if (shapes.format().equals("WKT")) {
        jts(new String(file, StandardCharsets.UTF_8))
            .ifPresent(geometry -> assertThat(places(shapes)).as(which).containsAll(geometry));
      }
    } catch (BadInputException e) {
      assertThat(e.getMessage()).as(which).startsWith("in:").contains("; ").hasSizeLessThan(500);
      assertThat(e.getMessage().chars()).as(which).allMatch(c -> c >= ' ');
    } catch (RuntimeException | StackOverflowError e) {
      throw new AssertionError(which, e);
    }
  }

  private static List<List<Double>> places(Shapes shapes) {
    List<List<Double>> places = new ArrayList<>();
    for (Shape shape : shapes.shapes()) {
      for (int v = 0; v < shape.points().size(); v++) {
        places.add(List.of(shape.points().x(v), shape.points().y(v)));
      }
    }
    return places;
  }

  /** The vertices of the first geometry, if JTS takes it. */
  private static Optional<List<List<Double>>> jts(String text) {
    try {
      Geometry read = new WKTReader().read(text);
      return Optional.of(
          Arrays.stream(read.getCoordinates()).map(DamagedFilesTest::place).toList());
    } catch (ParseException | IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  private static List<Double> place(Coordinate of) {
    return List.of(of.x, of.y);
  }
}
