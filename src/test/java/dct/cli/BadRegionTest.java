package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Regions that are none, in five formats: status 3, one line {@code FILE:LINE: cause; cure}. A
 * slash stands for a line break.
 */
class BadRegionTest {
  private static final String SQUARE = "0 0/9 0/9 9/0 9/";
  private static final String NODES = "7 2 0 0/1 0 0/2 9 0/3 9 9/4 0 9/5 2 2/6 4 2/7 3 4/";
  private static final String POINTS =
      "\"points\": [[0, 0], [9, 0], [9, 9], [0, 9], [2, 2], [4, 2], [3, 4]]";

  @TempDir Path folder;

  private static Arguments bad(String name, String text, String message) {
    return Arguments.of(name, text.replace('/', '\n'), message);
  }

  static Stream<Arguments> badRegions() {
    return Stream.of(texts(), jsons(), geoJsons(), wellKnownTexts(), polys()).flatMap(all -> all);
  }

  private static Stream<Arguments> texts() {
    return Stream.of(
        bad(
            "fixed one",
            SQUARE + "hole/2 2/3 2/3 3/fixed 1/",
            ":9: \"fixed\" stands without the numbers of two vertices behind it; write fix"
                + "ed i j"),
        bad(
            "fixed three",
            SQUARE + "fixed 0 2 3/",
            ":5: \"fixed\" stands without the numbers of two vertices behind it; write fix"
                + "ed i j"),
        bad(
            "fixed word",
            SQUARE + "hole/2 2/3 2/3 3/fixed a b/",
            ":9: \"fixed\" stands without the numbers of two vertices behind it; write fix"
                + "ed i j"),
        bad(
            "fixed neg",
            SQUARE + "hole/2 2/3 2/3 3/fixed -1 2/",
            ":9: \"fixed\" stands without the numbers of two vertices behind it; write fix"
                + "ed i j"),
        bad(
            "fixed float",
            SQUARE + "hole/2 2/3 2/3 3/fixed 0.5 2/",
            ":9: \"fixed\" stands without the numbers of two vertices behind it; write fix"
                + "ed i j"),
        bad(
            "fixed cross",
            SQUARE + "sites/2 2/4 2/2 4/4 4/fixed 4 7/fixed 5 6/",
            ":6: edges v4–v7 and v5–v6 cross at (3, 3); move a vertex of one of them"),
        bad(
            "fixed through hole",
            SQUARE + "hole/3 3/6 3/6 6/3 6/fixed 0 2/",
            ":8: vertex v6 touches edge v0–v2 at (6, 6); move it off the edge"),
        bad(
            "fixed huge",
            SQUARE + "fixed 0 99999999999/",
            ":5: \"fixed\" stands without the numbers of two vertices behind it; write fix"
                + "ed i j"),
        bad(
            "holes word",
            SQUARE + "holes/2 2/3 2/3 3/",
            ":5: \"holes\" is no word of a region; write hole, sites or fixed i j"),
        bad(
            "site in hole",
            SQUARE + "hole/3 3/6 3/6 6/3 6/sites/4 4/",
            ":11: site v8 lies outside of the region, (4, 4); move it inside, or remove " + "it"),
        bad(
            "hole cross",
            SQUARE + "hole/2 2/8 8/8 2/2 8/",
            ":6: edges v4–v5 and v6–v7 cross at (5, 5); move a vertex of one of them"),
        bad(
            "site on edge",
            SQUARE + "sites/4 0/",
            ":6: vertex v4 touches edge v0–v1 at (4, 0); move it off the edge"),
        bad(
            "only sites",
            "# kind: region/sites/1 1/2 2/1 2/",
            ": it holds no rings that are apart, as a region has them; read it by --as p"
                + "oints"),
        bad(
            "three numbers",
            SQUARE + "hole/2 2 1/3 2 1/3 3 1/",
            ":6: there are 3 numbers here, but 2 in line 1; write one vertex a line, as "
                + "two numbers x y"),
        bad(
            "hole line",
            SQUARE + "hole/2 2/3 3/4 4/",
            ":6: the boundary turns back along itself at vertex v4, (2, 2); move or remo"
                + "ve that vertex, or give --touching split or --touching hair"),
        bad(
            "hole spike",
            SQUARE + "hole/2 2/6 2/3 2/3 5/",
            ":7: the boundary turns back along itself at vertex v5, (6, 2); move or remo"
                + "ve that vertex, or give --touching split or --touching hair"),
        bad(
            "fixed twice dup hole",
            SQUARE + "hole/2 2/4 2/4 4/hole/2 2/4 2/4 4/",
            ":10: vertices v4 and v7 are both at (2, 2); remove one of them"),
        bad(
            "site twice",
            SQUARE + "sites/4 4/5 5/4 4/",
            ":8: vertices v4 and v6 are both at (4, 4); remove one of them"));
  }

  private static Stream<Arguments> jsons() {
    return Stream.of(
        bad(
            "ring oob",
            "{\"kind\": \"region\", " + POINTS + ", \"rings\": [[0, 1, 2, 3], [4, 5, 7]]}",
            ":1: there is no vertex 7; correct \"rings\" and \"fixed\""),
        bad(
            "ring twice",
            "{\"kind\": \"region\", " + POINTS + ", \"rings\": [[0, 1, 2, 3], [4, 5, 4]]}",
            ":1: vertex 4 is on two rings, or twice on one; correct \"rings\" and \"fixed\""),
        bad(
            "rings obj",
            "{\"kind\": \"region\", " + POINTS + ", \"rings\": {\"a\": 1}}",
            ":1: \"rings\" is not a list of lists of vertices, at rings; write [[u, v, w, "
                + "…], …], the outer ring first"),
        bad(
            "ring str",
            "{\"kind\": \"region\", " + POINTS + ", \"rings\": [[0, 1, 2, \"x\"]]}",
            ":1: \"rings\" is not a list of lists of vertices, at rings[0][3]; write [[u, "
                + "v, w, …], …], the outer ring first"),
        bad(
            "fixed three",
            "{\"kind\": \"region\", "
                + POINTS
                + ", \"rings\": [[0, 1, 2, 3], [4, 5, 6]], \"fixed\": [[0, 4, 5]]}",
            ":1: \"fixed\" is not a list of pairs, at fixed[0][2]; write [[u, v], …]"),
        bad(
            "fixed oob",
            "{\"kind\": \"region\", "
                + POINTS
                + ", \"rings\": [[0, 1, 2, 3], [4, 5, 6]], \"fixed\": [[0, 40]]}",
            ":1: there is no vertex 40; correct \"rings\" and \"fixed\""),
        bad(
            "no points",
            "{\"kind\": \"region\", \"rings\": [[0, 1, 2]]}",
            ":1: there is no field \"points\"; write \"points\": [[x, y], …]"),
        bad(
            "empty rings",
            "{\"kind\": \"region\", " + POINTS + ", \"rings\": []}",
            ":1: the field \"rings\" has no ring, or one without vertices; correct \"rings\""
                + " and \"fixed\""),
        bad(
            "empty ring",
            "{\"kind\": \"region\", " + POINTS + ", \"rings\": [[0, 1, 2, 3], []]}",
            ":1: the field \"rings\" has no ring, or one without vertices; correct \"rings\""
                + " and \"fixed\""),
        bad(
            "ring frac",
            "{\"kind\": \"region\", " + POINTS + ", \"rings\": [[0, 1, 2, 3], [4, 5, 6.5]]}",
            ":1: \"rings\" is not a list of lists of vertices, at rings[1][2]; write [[u, "
                + "v, w, …], …], the outer ring first"),
        bad(
            "neg",
            "{\"kind\": \"region\", " + POINTS + ", \"rings\": [[0, 1, 2, 3], [-4, 5, 6]]}",
            ":1: there is no vertex -4; correct \"rings\" and \"fixed\""),
        bad(
            "kind",
            "{\"kind\": \"regoin\", " + POINTS + ", \"rings\": [[0, 1, 2, 3], [4, 5, 6]]}",
            ":1: \"regoin\" is not a kind of input; write \"kind\": \"polygon\", \"points\" or \""
                + "region\""),
        bad(
            "fixed self",
            "{\"kind\": \"region\", "
                + POINTS
                + ", \"rings\": [[0, 1, 2, 3], [4, 5, 6]], \"fixed\": [[4, 4]]}",
            ":1: a fixed edge joins vertex 4 with itself; correct \"rings\" and \"fixed\""),
        bad(
            "null",
            "{\"kind\":\"region\",\"points\":[[0,0],[9,0],null,[0,9]],\"rings\":[[0,1,2,3]]}",
            ":1: a point is not a pair of numbers, at points[2]; write \"points\": [[x, y]"
                + ", …]"),
        bad(
            "trunc",
            "{\"kind\":\"region\",\"points\":[[0,0],[9,0],[9,9],[0,9]],\"rings\":[[0,1,2",
            ":1: the JSON text ends too early; restore the rest of the file"),
        bad(
            "lines",
            "{\"kind\":\"region\",/\"points\":[/[0,0],/[9,0],/[9,9],/[0,9]],/\"rings\":[/[0,1,2,"
                + "3],/[0,1,7]]}/",
            ":9: vertex 0 is on two rings, or twice on one; correct \"rings\" and \"fixed\""),
        bad(
            "lines",
            "{\"kind\":\"region\",/\"points\":[/[0,0],/[9,0],/[9,9],/[0,9]],/\"rings\":[/[0,1,2,"
                + "3]],/\"fixed\":[/[0,2],[1,8]]}/",
            ":10: there is no vertex 8; correct \"rings\" and \"fixed\""));
  }

  private static Stream<Arguments> geoJsons() {
    return Stream.of(
        bad(
            "nan",
            "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[9,0],[9,NaN],[0,0]]]}",
            ":1: this is not JSON as expected, at coordinates[0][2][1]; correct it"),
        bad(
            "depth",
            "{\"type\":\"Polygon\",\"coordinates\":[[0,0],[9,0],[9,9]]}",
            ":1: the coordinates of a Polygon are not nested as they should be; see RFC " + "7946"),
        bad(
            "empty",
            "{\"type\":\"Polygon\",\"coordinates\":[]}",
            ":1: there is no geometry with points in this GeoJSON; write \"type\": \"Polygo"
                + "n\", \"coordinates\": [[[x, y], …]]"),
        bad(
            "hole empty",
            "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[9,0],[9,9],[0,0]],[]]}",
            ":1: points and lists of points stand side by side, at coordinates[2]; part " + "them"),
        bad(
            "point",
            "{\"type\":\"Point\",\"coordinates\":[0,0]}",
            ": it holds no rings that are apart, as a region has them; read it by --as p"
                + "oints"),
        bad(
            "type",
            "{\"type\":\"Poligon\",\"coordinates\":[[[0,0],[9,0],[9,9],[0,0]]]}",
            ":1: \"Poligon\" is no type of a geometry with points; write \"type\": \"Polygon\""),
        bad(
            "nocoord",
            "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Polygon\"}}",
            ":1: there is no geometry with points in this GeoJSON; write \"type\": \"Polygo"
                + "n\", \"coordinates\": [[[x, y], …]]"),
        bad(
            "hole out",
            "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[9,0],[9,9],[0,0]],[[20,20],[21,20]"
                + ",[21,21],[20,20]]]}",
            ":1: vertex v5 of a hole lies outside of the outer ring, (21, 21); move "
                + "the hole into the region, or make it a region of its own"));
  }

  private static Stream<Arguments> wellKnownTexts() {
    return Stream.of(
        bad(
            "unclosed",
            "POLYGON ((0 0, 9 0, 9 9, 0 0), (2 1, 3 1, 3 2, 2 1)/",
            ":2: the end of the file stands where , or ) is missing; write it"),
        bad(
            "word",
            "POLYGON ((0 0, 9 0, 9 9, 0 0), (2 1, x 1, 3 2, 2 1))/",
            ":1: \"x\" is not a number; write two numbers x y for each point"),
        bad(
            "empty",
            "POLYGON EMPTY/",
            ":2: all geometries are empty; write a POLYGON or MULTIPOINT with points"),
        bad(
            "noparen",
            "POLYGON (0 0, 9 0, 9 9, 0 0)/",
            ":1: \"0\" stands where ( is missing; write it"),
        bad(
            "type",
            "POLYGONE ((0 0, 9 0, 9 9, 0 0))/",
            ":1: \"POLYGONE\" is not a number; write one vertex a line, as two numbers x y"),
        bad(
            "after",
            "POLYGON ((0 0, 9 0, 9 9, 0 0)) ))/",
            ":1: \")\" is no geometry of WKT; write POLYGON ((x y, …))"),
        bad(
            "points",
            "MULTIPOINT (0 0, 9 0, 9 9)/",
            ": it holds no rings that are apart, as a region has them; read it by --as p"
                + "oints"),
        bad(
            "hole emptyparen",
            "POLYGON ((0 0, 9 0, 9 9, 0 0), ())/",
            ":1: \")\" is not a number; write two numbers x y for each point"),
        bad(
            "onenum",
            "POLYGON ((0 0, 9 0, 9 9, 0 0), (2 1, 3, 3 2, 2 1))/",
            ":1: \",\" is not a number; write two numbers x y for each point"));
  }

  private static Stream<Arguments> polys() {
    return Stream.of(
        bad(
            "oob",
            NODES + "7 0/1 1 2/2 2 3/3 3 4/4 4 1/5 5 6/6 6 7/7 7 50/1/1 3 3/",
            ":16: there is no vertex 50; correct the segment"),
        bad(
            "few segments",
            NODES + "9 0/1 1 2/2 2 3/",
            ":11: the file ends after 2 of 9 segments; correct the count, or fetch the f"
                + "ile again if it was cut off"),
        bad(
            "few holes",
            NODES + "7 0/1 1 2/2 2 3/3 3 4/4 4 1/5 5 6/6 6 7/7 7 5/3/1 3 3/",
            ":18: the file ends after 1 of 3 points of holes; correct the count, or fetc"
                + "h the file again if it was cut off"),
        bad(
            "hole word",
            NODES + "7 0/1 1 2/2 2 3/3 3 4/4 4 1/5 5 6/6 6 7/7 7 5/1/1 x 3/",
            ":18: \"x\" is not a finite number; correct it"),
        bad(
            "seg one",
            NODES + "7 0/1 1 2/2 2 3/3 3/4 4 1/5 5 6/6 6 7/7 7 5/1/1 3 3/",
            ":12: a number is missing, the line has only 2; correct or remove it"),
        bad(
            "open",
            NODES + "3 0/1 1 2/2 2 3/3 3 4/0/",
            ":2: only one segment ends at this vertex, and there is no ring; add the seg"
                + "ments that close it"),
        bad("count neg", NODES + "-3 0/", ":9: a count is -3; correct it"),
        bad("count word", NODES + "x 0/", ":9: \"x\" is not a whole number below 10⁹; correct it"),
        bad(
            "fixed cross",
            NODES + "8 0/1 1 2/2 2 3/3 3 4/4 4 1/5 5 6/6 6 7/7 7 5/8 1 3/1/1 3 2.5/",
            ":2: 3 segments end at this vertex, and no markers tell which are of rings; "
                + "give those of rings the marker 1"),
        bad(
            "nodes trunc",
            "7 2 0 0/1 0 0/2 9 0/",
            ":3: the file ends after 2 of 7 vertices; correct the count, or fetch the fi"
                + "le again if it was cut off"),
        bad(
            "segfloat",
            NODES + "7 0/1 1 2/2 2 3/3 3 4/4 4 1/5 5 6/6 6 7/7 7 5.5/1/1 3 3/",
            ":16: \"5.5\" is not a whole number below 10⁹; correct it"),
        bad(
            "hole point missing y",
            NODES + "7 0/1 1 2/2 2 3/3 3 4/4 4 1/5 5 6/6 6 7/7 7 5/1/1 3/",
            ":18: a number is missing, the line has only 2; correct or remove it"));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("badRegions")
  void a_region(String name, String text, String message) throws IOException {
    Path file = Files.writeString(folder.resolve("in.txt"), text);
    for (String verb : new String[] {"check", "triangulate"}) {
      CliRun run = CliRun.of(verb, file, "--as", "region");
      assertThat(run.err()).as(name).isEqualTo(file + message + "\n");
      assertThat(message).matches("(?s)(:\\d+)?: [^;]+; [^;]+");
      assertThat(run.out()).isEmpty();
      assertThat(run.status()).isEqualTo(3);
    }
  }

  /** What is left out is said, and the rest is read. */
  @Test
  void what_is_left_out_is_said() throws IOException {
    Path empty = Files.writeString(folder.resolve("empty.txt"), "0 0\n9 0\n9 9\nhole\n");
    assertLeavesOut(
        CliRun.of("check", empty),
        empty + ": 1 ring or list of sites without vertices is left out\n");
    Path idle =
        Files.writeString(
            folder.resolve("idle.poly"),
            "3 2 0 0\n1 0 0\n2 9 0\n3 9 9\n3 0\n1 1 2\n2 2 3\n3 3 1\n1\n1 30 30\n");
    assertLeavesOut(
        CliRun.of("check", idle, "--as", "region"), idle + ": 1 point of a hole lies in no ring\n");
  }

  private static void assertLeavesOut(CliRun run, String note) {
    assertThat(run.err()).isEqualTo(note);
    assertThat(run.status()).isZero();
  }
}
