package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.io.format.Drawing;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Scanner;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.io.ParseException;
import org.locationtech.jts.io.WKTReader;
import org.locationtech.jts.io.geojson.GeoJsonReader;

/** Data for other programs, judged by JTS and by readers that are written here anew. */
class DataFileTest {
  private static final Points SQUARE = Points.ofPairs(0, 0, 4, 0.5, 4, 4, 0, 4);

  private static Solution solution(Domain domain, Points points) {
    Instance instance = Instance.of(domain, "the \"square\"", points, Progress.NONE);
    Method method = domain == Domain.SITES ? Method.DELAUNAY : Method.MONOTONE;
    return Solution.of(instance, method, Progress.NONE);
  }

  private static String text(FileEnding ending, Drawing drawing) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    DataFile.write(out, ending, drawing, Progress.NONE);
    return out.toString(StandardCharsets.UTF_8);
  }

  private static Points random(int n, long seed, boolean whole) {
    Random random = new Random(seed);
    double[] pairs =
        random
            .doubles(2L * n)
            .map(x -> whole ? Math.rint(1e6 * x) : Math.scalb(x - 0.5, random.nextInt(80) - 40))
            .toArray();
    return Points.ofPairs(pairs);
  }

  private static void same(Coordinate[] read, Points points) {
    for (int v = 0; v < points.size(); v++) {
      assertThat(read[v].x).isEqualTo(points.x(v));
      assertThat(read[v].y).isEqualTo(points.y(v));
    }
  }

  @ParameterizedTest
  @EnumSource(
      value = Domain.class,
      names = {"POLYGON", "SITES"})
  void jts_reads_what_is_written_for_maps(Domain domain) throws IOException, ParseException {
    for (int seed = 0; seed < 50; seed++) {
      Points points = random(3 + seed, seed, seed % 2 == 0);
      Drawing drawing = Drawing.of("x", domain, points);
      int count = points.size() + (domain == Domain.POLYGON ? 1 : 0); // a ring is closed
      Coordinate[] wkt = new WKTReader().read(text(FileEnding.WKT, drawing)).getCoordinates();
      Coordinate[] geo =
          new GeoJsonReader().read(text(FileEnding.GEOJSON, drawing)).getCoordinates();
      assertThat(wkt).hasSize(count);
      assertThat(geo).hasSize(count);
      same(wkt, points);
      same(geo, points);
    }
  }

  @Test
  void nothing_is_a_geometry_too() throws IOException, ParseException {
    for (Domain domain : Domain.applications()) {
      Drawing nothing = Drawing.of("x", domain, Points.ofPairs());
      assertThat(new WKTReader().read(text(FileEnding.WKT, nothing)).isEmpty()).isTrue();
      assertThat(new GeoJsonReader().read(text(FileEnding.GEOJSON, nothing)).isEmpty()).isTrue();
    }
  }

  @Test
  void meshes_hold_vertices_and_triangles_or_one_face() throws IOException {
    for (int seed = 0; seed < 30; seed++) {
      Solution solution = solution(Domain.SITES, random(3 + seed, seed, false));
      Triangulation made = solution.triangulation();
      Scanner off = new Scanner(text(FileEnding.OFF, Drawing.of(solution)));
      assertThat(off.next()).isEqualTo("OFF");
      assertThat(off.nextInt()).isEqualTo(made.vertexCount());
      assertThat(off.nextInt()).isEqualTo(made.triangleCount());
      assertThat(off.nextInt()).isZero();
      vertices(off, "", made.points());
      faces(off, "3", 0, made);
      Scanner obj = new Scanner(text(FileEnding.OBJ, Drawing.of(solution)));
      vertices(obj, "v", made.points());
      faces(obj, "f", 1, made);
    }
    Drawing ring = Drawing.of("x", Domain.POLYGON, SQUARE);
    assertThat(text(FileEnding.OFF, ring)).startsWith("OFF\n4 1 0\n").endsWith("\n4 0 1 2 3\n");
    assertThat(text(FileEnding.OBJ, ring)).endsWith("\nf 1 2 3 4\n");
    Drawing sites = Drawing.of("x", Domain.SITES, SQUARE);
    assertThat(text(FileEnding.OFF, sites)).startsWith("OFF\n4 0 0\n").endsWith("\n0 4 0\n");
  }

  private static void vertices(Scanner in, String word, Points points) {
    for (int v = 0; v < points.size(); v++) {
      if (!word.isEmpty()) {
        assertThat(in.next()).isEqualTo(word);
      }
      assertThat(Double.parseDouble(in.next())).isEqualTo(points.x(v));
      assertThat(Double.parseDouble(in.next())).isEqualTo(points.y(v));
      assertThat(in.next()).isEqualTo("0");
    }
  }

  private static void faces(Scanner in, String word, int first, Triangulation made) {
    int[] corners = made.triangles();
    for (int i = 0; i < corners.length; i++) {
      if (i % 3 == 0) {
        assertThat(in.next()).isEqualTo(word);
      }
      assertThat(in.nextInt()).isEqualTo(corners[i] + first);
    }
    assertThat(in.hasNext()).isFalse();
  }

  @Test
  void triangles_files(@TempDir Path folder) throws IOException {
    Solution solution = solution(Domain.POLYGON, SQUARE);
    Drawing drawing = Drawing.of(solution);
    String nodes = "4 2 0 0\n0 0 0\n1 4 0.5\n2 4 4\n3 0 4\n";
    assertThat(text(FileEnding.NODE, drawing)).isEqualTo(nodes);
    assertThat(text(FileEnding.POLY, drawing))
        .isEqualTo(nodes + "4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
    Drawing sites = Drawing.of("x", Domain.SITES, SQUARE);
    assertThat(text(FileEnding.POLY, sites)).isEqualTo(nodes + "0 0\n0\n");
    Path ele = folder.resolve("s.ele");
    assertThat(DataFile.write(ele, FileEnding.ELE, drawing, Progress.NONE))
        .containsExactly(ele, folder.resolve("s.node"));
    assertThat(folder.resolve("s.node")).hasContent(nodes);
    assertThat(Files.readString(ele)).startsWith("2 3 0\n0 ").hasLineCount(3);
    String[] edges = text(FileEnding.EDGE, drawing).split("\n", -1);
    assertThat(edges[0]).isEqualTo("5 1");
    assertThat(edges).filteredOn(line -> line.endsWith(" 1")).hasSize(1 + 4);
  }

  @Test
  void the_challenge_can_replay_the_flips() throws IOException {
    for (int seed = 0; seed < 20; seed++) {
      Solution plain = solution(Domain.SITES, random(5 + 4 * seed, seed, true));
      Solution flipped = plain.flipped(Progress.NONE);
      Points points = flipped.instance().points();
      JsonObject instance = json(FileEnding.INSTANCE, flipped);
      JsonArray both = instance.getAsJsonArray("triangulations");
      assertThat(instance.getAsJsonArray("points_x")).hasSize(5 + 4 * seed);
      assertThat(both).hasSize(2);
      JsonArray steps = json(FileEnding.SOLUTION, flipped).getAsJsonArray("flips");
      assertThat(steps).hasSize(2);
      assertThat(steps.get(1).getAsJsonArray()).isEmpty();
      Set<Set<Integer>> present = edges(both.get(0).getAsJsonArray());
      steps.get(0).getAsJsonArray().forEach(step -> replay(points, present, step.getAsJsonArray()));
      assertThat(present).isEqualTo(edges(both.get(1).getAsJsonArray()));
      assertThat(json(FileEnding.INSTANCE, plain).getAsJsonArray("triangulations")).hasSize(1);
      assertThat(json(FileEnding.SOLUTION, plain).getAsJsonArray("flips").toString())
          .isEqualTo("[[]]");
    }
  }

  private static JsonObject json(FileEnding ending, Solution solution) throws IOException {
    JsonObject json = JsonParser.parseString(text(ending, Drawing.of(solution))).getAsJsonObject();
    assertThat(json.get("instance_uid").getAsString()).isEqualTo("the \"square\"");
    assertThat(json.get("content_type").getAsString()).startsWith("CGSHOP2026_");
    return json;
  }

  private static Set<Set<Integer>> edges(JsonArray list) {
    Set<Set<Integer>> edges = new HashSet<>();
    list.forEach(edge -> edges.add(ends(edge.getAsJsonArray())));
    assertThat(edges).hasSize(list.size());
    return edges;
  }

  private static Set<Integer> ends(JsonArray edge) {
    return Set.of(edge.get(0).getAsInt(), edge.get(1).getAsInt());
  }

  /** Flips an edge as the challenge does: it is named by its ends, the new one joins the apexes. */
  private static void replay(Points points, Set<Set<Integer>> present, JsonArray step) {
    assertThat(step).hasSize(1);
    JsonArray edge = step.get(0).getAsJsonArray();
    int u = edge.get(0).getAsInt();
    int v = edge.get(1).getAsInt();
    Set<Integer> made = Set.of(apex(points, present, u, v), apex(points, present, v, u));
    assertThat(present.remove(Set.of(u, v))).isTrue();
    assertThat(present.add(made)).isTrue();
  }

  /** The third corner of the triangle on the left of an edge: it has no vertex inside. */
  private static int apex(Points points, Set<Set<Integer>> present, int u, int v) {
    return IntStream.range(0, points.size())
        .filter(c -> c != u && c != v && left(points, u, v, c))
        .filter(c -> present.contains(Set.of(u, c)) && present.contains(Set.of(v, c)))
        .filter(c -> IntStream.range(0, points.size()).noneMatch(p -> inside(points, u, v, c, p)))
        .findFirst()
        .orElseThrow();
  }

  private static boolean inside(Points points, int u, int v, int c, int p) {
    return left(points, u, v, p) && left(points, v, c, p) && left(points, c, u, p);
  }

  /** Exact for whole coordinates up to a million. */
  private static boolean left(Points p, int a, int b, int c) {
    return (p.x(b) - p.x(a)) * (p.y(c) - p.y(a)) - (p.y(b) - p.y(a)) * (p.x(c) - p.x(a)) > 0;
  }

  @Test
  void what_a_format_cannot_hold_is_said_in_a_sentence(@TempDir Path folder) throws IOException {
    Path ele = folder.resolve("a.ele");
    Drawing ring = Drawing.of("x", Domain.POLYGON, SQUARE);
    assertThatThrownBy(() -> DataFile.write(ele, FileEnding.ELE, ring, Progress.NONE))
        .isInstanceOf(CannotWriteException.class)
        .hasMessage(
            ele
                + ": it holds a triangulation, and there is none; triangulate first, or choose"
                + " .node or .poly");
    Drawing solution = Drawing.of(solution(Domain.SITES, SQUARE));
    assertThatThrownBy(() -> text(FileEnding.INSTANCE, solution))
        .hasMessage("coordinates of CG:SHOP are whole numbers; choose .json or .off");
    for (FileEnding ending : List.of(FileEnding.INSTANCE, FileEnding.SOLUTION)) {
      assertThatThrownBy(() -> text(ending, Drawing.of(solution(Domain.POLYGON, SQUARE))))
          .hasMessageContaining("sites alone");
      assertThatThrownBy(() -> text(ending, Drawing.of("x", Domain.SITES, SQUARE)))
          .hasMessageContaining("triangulate first");
    }
    try (Stream<Path> left = Files.list(folder)) {
      assertThat(left).isEmpty();
    }
  }
}
