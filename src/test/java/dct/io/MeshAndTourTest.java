package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import dct.core.triangulate.Domain;
import dct.io.text.BadInputException;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * OFF, OBJ, PLY, TSPLIB, CGAL and Qhull: read as meant, or refused in one sentence with its line.
 */
class MeshAndTourTest {
  private static final String SQUARE = "4 1 0\n0 0 1\n4 0 1\n4 4 1\n0 4 1\n4 3 2 1 0\n";
  private static final String TOUR =
      "NAME: a\nTYPE : TSP\nDIMENSION : 3\nNODE_COORD_SECTION\n1 0 0\n2 1e1 0\n3 5 5.5\nEOF\n";

  private static final String PLY =
      """
      ply
      format ascii 1.0
      element vertex 4
      property float x
      property float y
      element face 1
      property list uchar int vertex_index
      end_header
      0 0
      4 0
      4 4
      0 4
      4 3 2 1 0
      """;
  private static final String RBOX = "2 rbox 3 D2\n3\n0 0\n4 0\n4 5.5\n";

  private static PointDocument read(String text) throws IOException {
    return PointFile.read("in", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
  }

  private static String fault(String text) {
    return catchThrowableOfType(BadInputException.class, () -> read(text)).getMessage();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "OFF\n" + SQUARE,
        PLY,
        "nOFF 3\n" + SQUARE,
        "# one\nOFF " + SQUARE,
        "# c\no a\nv 0 0\nv 4 0\nv 4 4\nv 0 4\nf 4/1 3/1/2 2 1\n",
        "v 0 0 2\nv 4 0 2\nv 4 4 2\nv 0 4 2\nf -1 -2 -3 -4\n"
      })
  void one_face_is_a_ring_in_its_own_order(String text) throws IOException {
    PointDocument read = read(text);
    assertThat(read.declared()).contains(Domain.POLYGON);
    assertThat(read.points().size()).isEqualTo(4);
    assertThat(read.points().y(0)).isEqualTo(4);
    assertThat(read.points().x(1)).isEqualTo(4);
    assertThat(read.notes()).isEmpty();
  }

  @Test
  void several_faces_and_heights_are_told() throws IOException {
    PointDocument read = read("OFF\n4 2 0\n0 0 0\n4 0 0\n4 4 1\n0 4 0\n3 0 1 2\n3 0 2 3\n");
    assertThat(read.declared()).contains(Domain.SITES);
    assertThat(read.notes())
        .containsExactly(
            "z differs from vertex to vertex and is left out",
            "2 faces are left out, their vertices are read as sites");
    assertThat(read("OFF\n5 2 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n6 2 0\n4 0 1 2 3\n3 1 4 2\n").notes())
        .containsExactly(
            "2 faces, not all of them triangles, are left out, their vertices are read as sites");
  }

  @Test
  void a_tour_is_sites() throws IOException {
    PointDocument read = read(TOUR);
    assertThat(read.declared()).contains(Domain.SITES);
    assertThat(read.points().size()).isEqualTo(3);
    assertThat(read.points().y(2)).isEqualTo(5.5);
    assertThat(fault(TOUR.replace("3 5 5.5\n", ""))).startsWith("in:7: DIMENSION is 3, but there");
  }

  @Test
  void a_dimension_and_a_fourth_coordinate() throws IOException {
    assertThat(read("nOFF 2\n" + SQUARE.replace(" 1\n", "\n")).notes()).isEmpty();
    assertThat(read("STCN4nOFF\n3\n" + SQUARE.replace(" 1\n", " 1 1\n")).notes())
        .containsExactly("What STCN4nOFF holds behind the coordinates is left out");
  }

  @Test
  void polygons_of_cgal_are_no_table() throws IOException {
    assertThat(read("3 0 0 4 0 4 5.5\n").declared()).contains(Domain.POLYGON);
    assertThat(fault("3 0 0 4 0 4 5.5\n0\n")).startsWith("in:2: the count of the polygon is 0");
    assertThat(fault("3 0 0 4 0 4 5.5 0\n")).startsWith("in:1: these can be a count, 3 vertices");
    assertThat(fault("3 0 0 4 0 4 5.5\n2 0 0 4 0 4 5.5\n")).startsWith("in:1: of the 7 columns");
  }

  @Test
  void headers_of_ply_are_read_in_their_order() {
    assertThat(fault(PLY.replace("ascii", "binary_big_endian"))).startsWith("in:2: this is binary");
    assertThat(fault(PLY.replace("float y", "float w"))).startsWith("in:8: the vertices need");
    assertThat(fault(PLY.replace("vertex_index", "flags"))).startsWith("in:8: the faces do not");
    assertThat(fault(PLY.replace("element face 1", "face 1"))).startsWith("in:6: \"face\" is no");
    assertThat(fault("ply\nproperty float x\n")).startsWith("in:2: this property belongs to no");
    assertThat(fault("ply\nelement\n")).startsWith("in:2: a name is missing");
  }

  @Test
  void wrong_counts_and_numbers_are_refused_with_their_line() {
    assertThat(fault("OFF\n999999999 1 0\n0 0 0\n")).startsWith("in:3: the file ends after 1 of");
    assertThat(fault("OFF\n" + SQUARE.replace("4 3 2", "4 9 2"))).startsWith("in:7: there is no");
    assertThat(fault("OFF\n" + SQUARE.replace("4 3 2", "8 3 2"))).startsWith("in:7: the face has");
    assertThat(fault("OFF\n" + SQUARE + "1 2\n")).startsWith("in:8: the file goes on");
    assertThat(fault("v 0 0\nv 1 0\nv 1 1\nf 1 2 4\n")).startsWith("in:4: there is no vertex 4");
    assertThat(fault("v 0 x\n")).startsWith("in:1: \"x\" is not a finite number");
  }

  @Test
  void no_cut_off_file_fails_in_another_way() {
    String polygon = "4 0 0 4 0 4 4 0 4 1 3 1 1 2 2 2 1";
    String count = "1\n3 0\n0 0\n4 0\n4 4\n";
    for (String text :
        new String[] {
          "OFF\n" + SQUARE,
          PLY,
          RBOX,
          polygon,
          count,
          "nOFF 2\n" + SQUARE,
          TOUR,
          "v 0 0\nv 4 0\nv 4 4\nf -1 2/2 1\n"
        }) {
      for (int end = 0; end < text.length(); end++) {
        try {
          assertThat(read(text.substring(0, end)).points().size()).isPositive();
        } catch (BadInputException | IOException e) {
          assertThat(e).isInstanceOf(BadInputException.class).hasMessageMatching("in:\\d+: .+; .+");
        }
      }
    }
  }
}
