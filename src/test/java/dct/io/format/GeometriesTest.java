package dct.io.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.DataFile;
import dct.io.FileEnding;
import dct.io.PointDocument;
import dct.io.PointFile;
import dct.io.text.BadInputException;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.io.WKTWriter;
import org.locationtech.jts.io.geojson.GeoJsonWriter;

/** WKT and GeoJSON, written by JTS and by people; JSON of other kinds. */
class GeometriesTest {
  private static final GeometryFactory JTS = new GeometryFactory();

  private static Shapes read(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    try {
      return PointFile.shapes("in", new ByteArrayInputStream(bytes), Columns.TOLD_BY_CONTENT);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String described(String text) {
    return String.join("; ", read(text).shapes().stream().map(Shape::description).toList());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "POINT (1 2) | 1 sites",
        "POINT Z (1 2 3) | 1 sites",
        "MULTIPOINT ((1 2), (3 4)) | 2 sites",
        "MULTIPOINT (EMPTY, (1 2), empty) | 1 sites",
        "MULTILINESTRING ((0 0, 1 0), EMPTY) | path of 2 vertices",
        "MULTIPOLYGON (EMPTY, ((0 0, 1 0, 1 1, 0 0), EMPTY)) | ring of 3 vertices",
        "[[0,0,9,0,9,9,0,9]] | 4 points",
        "[[0,0,9,0,9,9,0,9],[1,1,2,1,2,2]] | 4 points; 3 points",
        "[[0,0,9,255,0,0],[9,0,9,255,0,0],[9,9,9,0,0,0]] | 3 points",
        "{\"vertices\":[0,0,9,0,9,9,0,9,1,1,2,1,2,2],\"holes\":[4],\"dimensions\":2} | ring of 4"
            + " vertices; hole of 3 vertices",
        "{\"dimensions\":3,\"holes\":[],\"vertices\":[0,0,5,9,0,5,9,9,5]} | ring of 3 vertices",
        "{\"vertices\":[[0,0],[9,0],[9,9],[0,9]],\"triangles\":[[0,1,2],[0,2,3]]} | 4 sites,"
            + " triangulated",
        "{\"vertices\":[0,0,9,0,9,9,0,9],\"triangles\":[0,1,2,0,2,3]} | 4 sites, triangulated",
        "multipoint(1 2,3 4) | 2 sites",
        "LINESTRING (0 0, 1 0, 1 1) | path of 3 vertices",
        "LINESTRING (0 0, 1 0, 1 1, 0 0) | ring of 3 vertices",
        "POLYGON ((0 0, 4 0, 4 4, 0 0)) | ring of 3 vertices",
        "POLYGON((0 0 1, 4 0 1, 4 4 1, 0 0 1)) | ring of 3 vertices",
        "POLYGON ZM ((0 0 1 2, 4 0 1 2, 4 4 1 2, 0 0 1 2)) | ring of 3 vertices",
        "POLYGONZ ((0 0 1, 4 0 1, 4 4 1, 0 0 1)) | ring of 3 vertices",
        "SRID=4326;POLYGON ((0 0, 4 0, 4 4, 0 0)) | ring of 3 vertices",
        "POLYGON ((0 0, 9 0, 9 9, 0 0), (4 1, 5 1, 5 2, 4 1)) | ring of 3 vertices; hole of 3"
            + " vertices",
        "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)), ((5 5, 6 5, 6 6, 5 5))) | ring of 3 vertices; ring"
            + " of 3 vertices",
        "GEOMETRYCOLLECTION (POINT (1 1), POLYGON EMPTY, LINESTRING (0 0, 1 1)) | 1 sites; path of"
            + " 2 vertices",
        "TIN (((0 0 0, 1 0 0, 1 1 0, 0 0 0))) | ring of 3 vertices",
        "TRIANGLE ((0 0, 1 0, 1 1, 0 0)) | ring of 3 vertices",
        "[[0,0],[1,0],[1,1]] | 3 points",
        "[[[0,0],[1,0],[1,1]],[[2,2],[3,2],[3,3],[2,3]]] | 3 points; 4 points",
        "[{\"x\":0,\"y\":0},{\"y\":0,\"x\":1},{\"x\":1,\"y\":1,\"z\":3}] | 3 points",
        "{\"type\":\"Point\",\"coordinates\":[1,2]} | 1 sites",
        "{\"coordinates\":[[[0,0],[1,0],[1,1],[0,0]]],\"type\":\"Polygon\"} | ring of 3 vertices",
        "{\"type\":\"Feature\",\"properties\":{\"pop\":3,\"name\":\"Bern\"},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[1,0],[1,1],[0,0]]]}}"
            + " | Bern, ring of 3 vertices",
        "{\"points_x\":[0,4,4,0],\"points_y\":[0,0,4,4],\"region_boundary\":[0,1,2]} | region, ring"
            + " of 3 vertices; all points, 4 sites",
        "{\"content_type\":\"CGSHOP2026_Instance\",\"instance_uid\":\"u\",\"points_x\":[0,4,4],\"points_y\":[0,0,4],\"triangulations\":[[[0,1],[1,2],[2,0]]]}"
            + " | u, 3 sites, triangulated",
        "{\"type\":\"x\",\"name\":\"euro\",\"points\":[{\"i\":0,\"x\":1,\"y\":2},{\"i\":1,\"x\":3,\"y\":4}]}"
            + " | euro, 2 sites",
        "{\"name\":\"c\",\"outer_boundary\":[{\"x\":0,\"y\":0},{\"x\":9,\"y\":0},{\"x\":9,\"y\":9}],\"holes\":[[{\"x\":4,\"y\":1},{\"x\":5,\"y\":1},{\"x\":5,\"y\":2}]]}"
            + " | c, ring of 3 vertices; c, hole of 3 vertices",
      })
  void forms(String text, String shapes) {
    assertThat(described(text)).isEqualTo(shapes);
  }

  @Test
  void foreign_members_of_geojson_are_skipped() {
    String ring = "\"coordinates\":[[[0,0],[1,0],[1,1],[0,0]]]";
    assertThat(
            described(
                "{\"type\":\"Feature\",\"x\":[\"a\"],\"y\":[null],\"vertices\":[true],\"triangles\":"
                    + "[\"t\"],\"holes\":[\"h\"],\"items\":[1],\"geometry\":{\"type\":\"Polygon\","
                    + ring
                    + "}}"))
        .isEqualTo("ring of 3 vertices");
    assertThatThrownBy(() -> read("{\"type\":\"Resolution\",\"geometry\":null}"))
        .hasMessageContaining("there is no geometry with points in this GeoJSON");
  }

  @Test
  void several_geometries_follow_each_other() {
    String triangle = "POLYGON ((0 0, 4 0, 4 4, 0 0))";
    assertThat(read("# two\n" + triangle + ";\n\n" + triangle + "\n").shapes()).hasSize(2);
    String features =
        "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"geometry\":null,"
            + "\"properties\":null},{\"type\":\"Feature\",\"id\":7,\"geometry\":{\"type\":"
            + "\"GeometryCollection\",\"geometries\":[{\"type\":\"Point\",\"coordinates\":[1,2,3]}"
            + "]}}],\"crs\":{\"a\":[1]}}";
    assertThat(described(features)).isEqualTo("7, 1 sites");
    assertThat(read(features).notes())
        .containsExactly(
            "Numbers behind x and y are left out", "1 geometry without points left out");
  }

  @Test
  void objects_on_lines_of_their_own_are_read_one_after_the_other() {
    String line =
        "{\"type\":\"Feature\",\"properties\":{\"name\":\"a\"},\"geometry\":"
            + "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[1,0],[1,1],[0,0]]]}}";
    assertThat(described(line + "\n\r\n" + line.replace("\"a\"", "\"b\"") + "\n\n"))
        .isEqualTo("a, ring of 3 vertices; b, ring of 3 vertices");
    Shape third = read((line + "\n").repeat(500)).shapes().get(499);
    assertThat(third.line(0)).isEqualTo(500);
    assertThatThrownBy(() -> read(line + "\n" + line + "\n" + line.replace("[1,1]", "[1]")))
        .hasMessageStartingWith("in:3: a point has one number only");
    assertThatThrownBy(() -> read(line + "\n" + line.substring(0, line.length() - 2)))
        .hasMessageStartingWith("in:2: the JSON text ends too early");
    assertThatThrownBy(() -> read(line + "\n]"))
        .hasMessage("in:2: something follows the JSON text; remove it");
    assertThatThrownBy(() -> read("[[0,0],[1,1],[2,3]]\n{}"))
        .hasMessage("in:2: something follows the JSON text; remove it");
    assertThatThrownBy(() -> read(line + line)).hasMessageContaining("not JSON as expected");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "POLYGON ((0 0, 4 0, 4 4, 0 0) | the end of the file stands where , or ) is missing; write"
            + " it",
        "MULTILINESTRING ((0 0, 1 0), EMPTIED) | \"EMPTIED\" stands where ( is missing; write it",
        "{\"vertices\":[0,0,9,0,9],\"holes\":[],\"dimensions\":2} | there are 5 numbers, which are"
            + " no vertices of 2 dimensions; give x and y of each",
        "{\"vertices\":[0,0,9,0,9,9],\"holes\":[3],\"dimensions\":2} | the holes do not begin at"
            + " increasing numbers from 1 to 2; correct \"holes\"",
        "{\"vertices\":[0,0,9,0,9,9],\"triangles\":[0,1,3]} | there is no vertex 3, they count from"
            + " 0 to 2; correct the triangle",
        "{\"vertices\":[0,0,9,0,9,9],\"triangles\":[0,1]} | a triangle has not three corners; write"
            + " [u, v, w]",
        "POLYGON (0 0, 4 0) | \"0\" stands where ( is missing; write it",
        "POLYGON ((0 0, 4 x)) | \"x\" is not a number; write two numbers x y for each point",
        "POLYGON ((0 0, 1e999 0)) | 1e999 is too large, a coordinate is at most 1.797e308; scale"
            + " the data",
        "POLYGON EMPTY | all geometries are empty; write a POLYGON or MULTIPOINT with points",
        "CIRCULARSTRING (0 0, 1 1, 2 0) | CIRCULARSTRING has curves, which are not read; write"
            + " straight lines",
        "POINT (1 2) BOX (1 2) | \"BOX\" is no geometry of WKT; write POLYGON ((x y, …))",
        "{\"type\":\"Polygon\",\"coordinates\":[[1,2],[3,4]]} | the coordinates of a Polygon are"
            + " not nested as they should be; see RFC 7946",
        "{\"coordinates\":[1,2]} | the type of a geometry is missing; write \"type\": \"Polygon\"",
        "{\"type\":\"Point\",\"coordinates\":[1]} | a point has one number only, at"
            + " coordinates[1]; write a point as [x, y]",
        "[[0,0],[4,0],[],[4,4]] | a point has no numbers, at [3]; write a point as [x, y]",
        "{\"type\":\"Polygon\",\"coordinates\":[[[],[0,0],[4,0],[4,4]]]} | a point has no numbers,"
            + " at coordinates[0][2]; write a point as [x, y]",
        "[1,2,3,4] | the numbers stand in one list; write [[x, y], [x, y], …]",
        "[[1,2],[[3,4]]] | points and lists of points stand side by side, at [2]; part them",
        "[[1,2],[3,4]] x | this is not JSON as expected; correct it",
        "[[1,2],[3,NaN]] | this is not JSON as expected, at [1][1]; correct it",
        "{\"type\":\"FeatureCollection\",\"features\":[]} | there is no geometry with points in"
            + " this GeoJSON; write \"type\": \"Polygon\", \"coordinates\": [[[x, y], …]]",
        "{\"content_type\":\"CGSHOP2026_Solution\",\"flips\":[]} | a solution of CG:SHOP without"
            + " points of its own; open its instance",
      })
  void faults(String text, String sentence) {
    assertThatThrownBy(() -> read(text))
        .isInstanceOf(BadInputException.class)
        .hasMessage("in:1: " + sentence);
  }

  @Test
  void what_jts_writes_is_read_as_it_was() {
    long seed = 20;
    Random random = new Random(seed);
    for (int round = 0; round < 300; round++) {
      List<Coordinate[]> rings = new ArrayList<>();
      Geometry geometry = multiPolygon(random, rings);
      GeoJsonWriter json = new GeoJsonWriter(17);
      for (String text : List.of(new WKTWriter().write(geometry), json.write(geometry))) {
        List<Shape> shapes = read(text).shapes();
        assertThat(shapes).as("seed %d, round %d", seed, round).hasSize(rings.size());
        for (int i = 0; i < rings.size(); i++) {
          same(shapes.get(i).points(), rings.get(i));
        }
      }
    }
  }

  private static void same(Points read, Coordinate[] written) {
    assertThat(read.size()).isEqualTo(written.length - 1); // JTS repeats the first
    for (int v = 0; v < read.size(); v++) {
      assertThat(Math.abs(read.x(v) - written[v].x)).isLessThan(1e-9) /* JTS writes 16 digits */;
      assertThat(Math.abs(read.y(v) - written[v].y)).isLessThan(1e-9) /* JTS writes 16 digits */;
    }
  }

  private static Geometry multiPolygon(Random random, List<Coordinate[]> rings) {
    Polygon[] polygons = new Polygon[1 + random.nextInt(3)];
    for (int p = 0; p < polygons.length; p++) {
      LinearRing[] holes = new LinearRing[random.nextInt(3)];
      LinearRing shell = ring(random, rings);
      for (int h = 0; h < holes.length; h++) {
        holes[h] = ring(random, rings);
      }
      polygons[p] = JTS.createPolygon(shell, holes);
    }
    return polygons.length == 1 ? polygons[0] : JTS.createMultiPolygon(polygons);
  }

  private static LinearRing ring(Random random, List<Coordinate[]> rings) {
    Coordinate[] ring = new Coordinate[4 + random.nextInt(5)];
    for (int v = 0; v + 1 < ring.length; v++) {
      ring[v] = new Coordinate(random.nextGaussian() * 100, random.nextInt(1000));
    }
    ring[ring.length - 1] = ring[0].copy();
    rings.add(ring);
    return JTS.createLinearRing(ring);
  }

  @Test
  void what_is_written_is_read_with_every_bit() throws IOException {
    Random random = new Random(5);
    for (int round = 0; round < 300; round++) {
      double[] pairs = new double[6 + 2 * random.nextInt(20)];
      Arrays.setAll(pairs, i -> Math.scalb(random.nextDouble() - 0.5, random.nextInt(2000) - 1000));
      Points points = Points.ofPairs(pairs);
      for (Domain domain : Domain.applications()) {
        for (FileEnding ending : List.of(FileEnding.WKT, FileEnding.GEOJSON)) {
          ByteArrayOutputStream out = new ByteArrayOutputStream();
          DataFile.write(out, ending, Drawing.of("x", domain, points), Progress.NONE);
          PointDocument read =
              PointFile.read("in", new ByteArrayInputStream(out.toByteArray()), Choice.NONE);
          assertThat(read.points()).isEqualTo(points);
          assertThat(read.declared()).contains(domain);
          assertThat(read.notes()).isEmpty();
        }
      }
    }
  }

  /** Cut anywhere, a text is read as something smaller or refused in a sentence. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "SRID=1; GEOMETRYCOLLECTION Z (POINT (1 2 3), POLYGON ((0 0 0, 4 0 0, 4 4 0, 0 0 0)))",
        "{\"type\":\"Feature\",\"properties\":{\"name\":\"x\"},\"geometry\":{\"type\":\"Polygon\","
            + "\"coordinates\":[[[0,0],[1,0],[1,1],[0,0]]]}}",
        "{\"points_x\":[0,4,4],\"points_y\":[0,0,4],\"triangulations\":[[[0,1],[1,2]]]}",
        "[{\"x\":0,\"y\":0},{\"x\":1,\"y\":0},{\"x\":1,\"y\":1}]",
        "{\"vertices\":[0,0,9,0,9,9,2,2],\"holes\":[],\"triangles\":[[0,1,2],[0,2,3]]}",
        "[[0,0,9,0,9,9,0,9],[1,1,2,1,2,2]]",
        "MULTIPOLYGON (EMPTY, ((0 0, 1 0, 1 1, 0 0), EMPTY))",
      })
  void cut_or_changed_texts_are_refused_in_a_sentence(String text) {
    for (int end = 0; end < text.length(); end++) {
      accepted(text.substring(0, end));
    }
    Random random = new Random(3);
    for (int round = 0; round < 5000; round++) {
      StringBuilder changed = new StringBuilder(text);
      for (int k = 0; k <= random.nextInt(3); k++) {
        String signs = "[]{}(),:\"0 -e\u0000\u00e4xZ";
        changed.setCharAt(
            random.nextInt(changed.length()), signs.charAt(random.nextInt(signs.length())));
      }
      accepted(changed.toString());
    }
  }

  /** Whether a text is read; if not, one sentence says why. */
  private static boolean accepted(String text) {
    try {
      return !read(text).shapes().isEmpty();
    } catch (BadInputException e) {
      assertThat(e.getMessage()).as(text).startsWith("in:").contains("; ").doesNotContain("\n");
      return false;
    }
  }

  @Test
  void deep_and_long_texts_do_no_harm() {
    assertThat(accepted("[".repeat(1_000_000))).isFalse();
    assertThat(accepted("{\"geometry\":".repeat(100_000))).isFalse();
    assertThat(accepted("GEOMETRYCOLLECTION (".repeat(100_000))).isFalse();
    assertThat(accepted("POLYGON ((" + " ".repeat(10_000_000) + "1 2")).isFalse();
    assertThat(accepted("POLYGON ((" + "1".repeat(10_000_000) + " 2")).isFalse();
    assertThat(read("MULTIPOINT (" + "1 2, ".repeat(2_000_000) + "3 4)").shapes()).hasSize(1);
  }
}
