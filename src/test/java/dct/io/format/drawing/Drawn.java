package dct.io.format.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.geometry.Points;
import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.text.BadInputException;
import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Reads drawings and says what was read on one line each. */
final class Drawn {
  private static final List<Format> FORMATS =
      List.of(new SvgFormat(), new IpeFormat(), new OtherXml());

  private Drawn() {}

  static Shapes read(byte[] file) throws IOException {
    BufferedInputStream in = new BufferedInputStream(new ByteArrayInputStream(file), Head.LENGTH);
    Head head = Head.of(in);
    return FORMATS.stream()
        .filter(format -> format.fits(head))
        .findFirst()
        .orElseThrow(() -> new BadInputException("in", 0, "this is no XML; mend it"))
        .read(Input.of("in", in));
  }

  static Shapes read(String file) throws IOException {
    return read(file.getBytes(StandardCharsets.UTF_8));
  }

  /** A line for each shape, as {@code ring a: 0 0, 10 0, 10 10}, and one for each note. */
  static String said(String file) throws IOException {
    Shapes shapes = read(file);
    return shapes.shapes().stream().map(Drawn::line).collect(Collectors.joining("\n"))
        + shapes.notes().stream().map(note -> "\n" + note).collect(Collectors.joining());
  }

  private static String line(Shape shape) {
    Points points = shape.points();
    String name = shape.label().isEmpty() ? "" : " " + shape.label();
    return shape.kind().word()
        + name
        + ": "
        + IntStream.range(0, points.size())
            .mapToObj(v -> number(points.x(v)) + " " + number(points.y(v)))
            .collect(Collectors.joining(", "));
  }

  private static String number(double value) {
    return value == (long) value ? Long.toString((long) value) : Double.toString(value);
  }

  static void refuses(String file, String sentence) {
    assertThatThrownBy(() -> read(file))
        .as(file)
        .isInstanceOf(BadInputException.class)
        .hasMessage("in:" + sentence);
  }

  /** Whatever is cut off or changed, it is read or refused in one sentence with a cure. */
  static void survivesDamage(String file, long seed) throws IOException {
    byte[] whole = file.getBytes(StandardCharsets.UTF_8);
    for (int end = 0; end < whole.length; end++) {
      readsOrRefuses(Arrays.copyOf(whole, end), "cut after " + end);
    }
    Random random = new Random(seed);
    for (int round = 0; round < 3000; round++) {
      byte[] damaged = whole.clone();
      for (int i = random.nextInt(4); i >= 0; i--) {
        byte other = whole[random.nextInt(whole.length)];
        damaged[random.nextInt(whole.length)] =
            random.nextInt(4) == 0 ? (byte) random.nextInt(256) : other;
      }
      readsOrRefuses(damaged, "seed " + seed + ", round " + round);
    }
  }

  private static void readsOrRefuses(byte[] file, String which) throws IOException {
    try {
      assertThat(read(file).shapes()).as(which).isNotEmpty();
    } catch (BadInputException e) {
      assertThat(e.getMessage()).as(which).startsWith("in:").contains("; ").doesNotContain("\n");
    }
  }
}
