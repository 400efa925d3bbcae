package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.format.Choice;
import dct.io.format.Columns;
import dct.io.format.Drawing;
import dct.io.format.Shapes;
import dct.io.text.BadInputException;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Lines that are longer than what is looked at of a file to tell its format. */
class LongLinesTest {
  private static final int VERTICES = 30_000;

  private static Points points() {
    Random random = new Random(5);
    return Points.of(
        random.doubles(VERTICES, -1000, 1000).toArray(),
        random.doubles(VERTICES, -1000, 1000).toArray());
  }

  private static PointDocument read(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    try {
      return PointFile.read("in", new ByteArrayInputStream(bytes), Choice.NONE);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String joined(Points points, String between, String behind) {
    StringBuilder text = new StringBuilder();
    for (int v = 0; v < points.size(); v++) {
      text.append(points.x(v)).append(between).append(points.y(v));
      text.append(v + 1 < points.size() ? behind : "");
    }
    return text.toString();
  }

  @ParameterizedTest
  @EnumSource(
      value = FileEnding.class,
      names = {"WKT", "GEOJSON", "POLY", "OFF", "OBJ"})
  void a_polygon_of_many_vertices_that_was_written_is_read(FileEnding ending) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    DataFile.write(out, ending, Drawing.of("", Domain.POLYGON, points()), Progress.NONE);
    PointDocument read = read(out.toString(StandardCharsets.UTF_8));
    assertThat(read.points()).isEqualTo(points());
    assertThat(read.declared()).contains(Domain.POLYGON);
  }

  @Test
  void a_polygon_of_cgal_in_one_line_is_read() {
    assertThat(read(VERTICES + " " + joined(points(), " ", " ") + "\n").points())
        .isEqualTo(points());
  }

  @Test
  void geometry_behind_a_long_property_is_read() {
    String text = "{\"type\": \"Feature\", \"properties\": {\"text\": \"" + "a".repeat(100_000);
    assertThat(
            read(text
                    + "\"}, \"geometry\": {\"type\": \"Polygon\", \"coordinates\":"
                    + " [[[0, 0], [1, 0], [0, 1], [0, 0]]]}}")
                .points()
                .size())
        .isEqualTo(3);
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      delimiter = '|',
      ignoreLeadingAndTrailingWhitespace = false,
      value = {
        "<svg xmlns='http://www.w3.org/2000/svg'><polygon points='|'/></svg>| ",
        "<svg xmlns='http://www.w3.org/2000/svg'><path d='M |z'/></svg>| L ",
        "<ipeselection pos='0 0'><path>| l h</path></ipeselection>| l ",
        "LINESTRING (|)|, ",
      })
  void a_drawing_in_one_line_is_read(String head, String end, String between) {
    String text = head + joined(points(), " ", between).replaceFirst(" l ", " m ") + end;
    assertThat(read(text).points()).isEqualTo(points());
  }

  @ParameterizedTest
  @ValueSource(strings = {"x", "1", "0 0 ", "1,", "(0, 0) ", "\"", "# ", "[", "{", "<", "3 "})
  void whatever_is_repeated_is_read_or_refused_in_a_sentence(String part) {
    String text = part.repeat(300_000 / part.length());
    byte[] bytes = (text + "\n").getBytes(StandardCharsets.UTF_8);
    BadInputException fault =
        catchThrowableOfType(
            BadInputException.class,
            () -> {
              Shapes read =
                  PointFile.shapes("in", new ByteArrayInputStream(bytes), Columns.TOLD_BY_CONTENT);
              assertThat(read.shapes()).isNotEmpty();
            });
    if (fault != null) {
      assertThat(fault.getMessage()).startsWith("in:").contains("; ").hasSizeLessThan(300);
    }
  }
}
