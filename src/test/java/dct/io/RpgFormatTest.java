package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.text.BadInputException;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/** Files of the first versions of Salzburg's Random Polygon Generator. */
class RpgFormatTest {
  private static final String SQUARE =
      """
      ################################################
      #    Data file for random polygon generator    #
      ################################################
      0.000000 1.000000 0.000000 1.000000
      4
      0.100000 0.100000
      0.900000 0.100000
      0.100000 0.800000
      0.900000 0.800000
      # number of polygons
      1
      POLYGON
      1
      2
      4
      3
      """;

  private static PointDocument read(String text) throws IOException {
    return PointFile.read("in", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
  }

  private static String fault(String text) {
    return catchThrowableOfType(BadInputException.class, () -> read(text)).getMessage();
  }

  @Test
  void theVerticesComeInTheOrderOfThePolygon() throws IOException {
    PointDocument read = read(SQUARE);
    assertThat(read.declared()).contains(Domain.POLYGON);
    assertThat(read.points()).isEqualTo(Points.ofPairs(0.1, 0.1, 0.9, 0.1, 0.9, 0.8, 0.1, 0.8));
    assertThat(read.notes()).isEmpty();
    String withoutLimits = SQUARE.replace("0.000000 1.000000 0.000000 1.000000\n", "");
    assertThat(read(withoutLimits).points()).isEqualTo(read.points());
  }

  @Test
  void pointsAloneAreSites() throws IOException {
    PointDocument read = read(SQUARE.substring(0, SQUARE.indexOf("# number")));
    assertThat(read.declared()).contains(Domain.SITES);
    assertThat(read.points().size()).isEqualTo(4);
  }

  @Test
  void whatIsWrongIsNamedWithItsLine() {
    assertThat(fault(SQUARE.replace("\n4\n3\n", "\n4\n5\n")))
        .isEqualTo("in:16: there is no point 5, they are numbered from 1 to 4");
    assertThat(fault(SQUARE.replace("\n4\n3\n", "\n")))
        .isEqualTo("in:14: a polygon has 2 vertices, but it needs 3; add vertices");
    assertThat(fault(SQUARE.replace("POLYGON\n", "")))
        .startsWith("in:12: a line POLYGON is missing");
    assertThat(fault(SQUARE.replace("\n1\nPOLYGON", "\n2\nPOLYGON")))
        .isEqualTo("in:16: the number of polygons is 2, but 1 follow; correct it");
    assertThat(fault(SQUARE + "POLYGON\n1\n2\n3\n"))
        .isEqualTo("in:17: the number of polygons is 1, but more follow; correct it");
    assertThat(fault(SQUARE.substring(0, SQUARE.indexOf("0.100000 0.800000"))))
        .startsWith("in:7: the file ends after 2 of 4 points");
  }

  @Test
  void severalPolygonsAreAChoice() {
    String two = SQUARE.replace("\n1\nPOLYGON", "\n2\nPOLYGON") + "POLYGON\n1\n2\n3\n";
    assertThat(fault(two)).startsWith("in: RPG with 2 shapes; choose one by --pick N");
  }
}
