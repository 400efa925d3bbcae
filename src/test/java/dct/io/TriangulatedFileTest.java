package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import dct.core.Progress;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.RandomSites;
import dct.io.format.Choice;
import dct.io.format.Drawing;
import dct.io.format.NoTriangulation;
import dct.io.text.BadInputException;
import dct.problem.Comparison;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.problem.verify.Verdict.Outcome;
import dct.problem.verify.Verifier;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Triangulations in the formats of mesh programs: they come back, or a sentence says why not. */
class TriangulatedFileTest {
  /** A concave polygon of five vertices, the last one inside the hull. */
  private static final String DART =
      "OFF/5 3 0/0 0 0/4 0 0/4 4 0/0 4 0/1 2 0/3 0 1 4/3 1 2 4/3 2 3 4/";

  /** Four sites and one inside, with all four triangles. */
  private static final String FAN = DART.replace("5 3 0", "5 4 0") + "3 3 0 4/";

  @TempDir private Path folder;

  private PointDocument read(String text) throws IOException {
    return read(text, Choice.NONE);
  }

  private PointDocument read(String text, Choice choice) throws IOException {
    Path file = Files.writeString(folder.resolve("in.off"), text.replace('/', '\n'));
    return PointFile.read(file, choice, Progress.NONE);
  }

  private String fault(String text) {
    BadInputException e = catchThrowableOfType(BadInputException.class, () -> read(text));
    return e.getMessage().replace(folder.resolve("in.off").toString(), "in");
  }

  private static Solution made(Instance instance) {
    Method method = Method.byDefault(instance.domain());
    return Solution.of(instance, method, Progress.NONE).flipped(Progress.NONE);
  }

  private static Instance random(Domain domain, int seed) {
    Points points =
        domain == Domain.SITES
            ? RandomSites.uniform(4 + 3 * seed, seed)
            : PolygonShape.TWO_OPT.generate(6 + 3 * seed, seed).points();
    return Instance.of(domain, "x", points, Progress.NONE);
  }

  private static Solution solution(PointDocument read) {
    return read.solution(Progress.NONE).orElseThrow();
  }

  @ParameterizedTest
  @EnumSource(
      value = FileEnding.class,
      names = {"OFF", "OBJ", "ELE", "EDGE"})
  void what_is_written_comes_back(FileEnding ending) throws IOException {
    for (Domain domain : Domain.applications()) {
      for (int seed = 0; seed < 25; seed++) {
        Solution written = made(random(domain, seed));
        Path file = folder.resolve("a" + ending.dotted());
        DataFile.write(file, ending, Drawing.of(written), Progress.NONE);
        PointDocument read = PointFile.read(file, Choice.NONE.as(domain), Progress.NONE);
        assertThat(read.points()).isEqualTo(written.instance().points());
        assertThat(read.notes()).isEmpty();
        Solution back = solution(read);
        assertThat(Comparison.of(back.triangulation(), written.triangulation()).isSame()).isTrue();
        assertThat(back.method()).isEmpty();
        assertThat(back.triangulation().count(EdgeKind.DIAGONAL))
            .isEqualTo(back.triangulation().edgeCount() - written.triangulation().boundaryCount());
        assertVerified(back);
        if (domain == Domain.SITES || seed > 1) { // a small polygon may be convex
          assertThat(PointFile.read(file, Progress.NONE).domain()).isEqualTo(domain);
        }
      }
    }
  }

  private static void assertVerified(Solution solution) {
    assertThat(
            Verifier.verify(ResultJson.claims(solution), Optional.empty(), Progress.NONE).outcome())
        .isEqualTo(Outcome.TRUE);
  }

  @Test
  void a_result_of_it_says_where_it_is_from_and_can_be_improved() throws IOException {
    Solution back = solution(read(FAN));
    assertThat(back.methodTitle()).isEqualTo("Read from in.off");
    assertThat(ResultJson.summary(back, Optional.empty())).contains("\"algorithm\": \"unknown\"");
    assertVerified(back.optimized(SearchLimits.DEFAULT, Progress.NONE));
    assertVerified(back.flipped(Progress.NONE));
  }

  @Test
  void vertices_of_a_polygon_are_put_in_the_order_of_the_rim() throws IOException {
    Random random = new Random(7);
    for (int seed = 2; seed < 20; seed++) {
      Instance instance = random(Domain.POLYGON, seed);
      Triangulation made = made(instance).triangulation();
      List<Integer> order = new ArrayList<>();
      for (int v = 0; v < instance.size(); v++) {
        order.add(v);
      }
      Collections.shuffle(order, random);
      Solution back = solution(read(shuffled(made, order)));
      assertThat(back.instance().domain()).isEqualTo(Domain.POLYGON);
      assertThat(back.counts()).isEqualTo(made(instance).counts());
      assertThat(back.triangulation().points().x(0)).isEqualTo(made.points().x(order.get(0)));
      assertVerified(back);
    }
  }

  /** The triangulation with its vertices in this order. */
  private static String shuffled(Triangulation made, List<Integer> order) {
    StringBuilder text = new StringBuilder("OFF/" + made.vertexCount() + " ");
    text.append(made.triangleCount()).append(" 0/");
    for (int v : order) {
      text.append(made.points().x(v)).append(' ').append(made.points().y(v)).append(" 0/");
    }
    int[] corners = made.triangles();
    for (int i = 0; i < corners.length; i++) {
      text.append(i % 3 == 0 ? "3 " : " ").append(order.indexOf(corners[i]));
      text.append(i % 3 == 2 ? "/" : "");
    }
    return text.toString();
  }

  @Test
  void all_vertices_on_a_concave_rim_are_a_polygon_others_sites() throws IOException {
    assertThat(read(DART).domain()).isEqualTo(Domain.POLYGON);
    assertThat(read(FAN).domain()).isEqualTo(Domain.SITES);
    assertThat(read(DART.replace("1 2 0", "-1 2 0")).domain()).isEqualTo(Domain.SITES);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "3 3 0 4 | 3 1 0 4 | 11: its triangles are no triangulation of its sites: the triangle is"
            + " there already, on line 8",
        "3 3 0 4 | 3 0 1 2 | 11: its triangles are no triangulation of its sites: the triangle lies"
            + " on that of line 8",
        "3 3 0 4 | 3 0 0 1 | 11: its triangles are no triangulation of its sites: the triangle has"
            + " the same corner twice",
        "1 2 0 | 4 2 0 | 9: its triangles are no triangulation of its sites: the corners of the"
            + " triangle are on one line",
        "1 2 0 | 0 0 0 | 8: its triangles are no triangulation of its sites: the corners of the"
            + " triangle are on one line",
        "5 4 0 | 5 5 0 | 11: the file ends after 4 of 5 faces",
        "5 4 0 | 5 3 0 | 11: the file goes on behind the last line that its counts announce",
        "3 3 0 4 | 3 3 0 5 | 11: there is no vertex 5",
        "1 2 0 | 1 NaN 0 | 7: \"NaN\" is not a finite number",
        "1 2 0 | 1 1e999 0 | 7: \"1e999\" is not a finite number"
      })
  void what_is_wrong_is_said_with_its_line(String from, String to, String fault) {
    assertThat(fault(FAN.replace("/" + from + "/", "/" + to + "/"))).startsWith("in:" + fault);
  }

  @Test
  void a_hole_a_missing_hull_edge_and_a_vertex_apart_are_no_triangulation() throws IOException {
    String square = "OFF/6 8 0/0 0 0/9 0 0/9 9 0/0 9 0/3 3 0/6 4 0/";
    String ring = "3 0 1 4/3 1 5 4/3 1 2 5/3 2 3 5/3 3 4 5/3 3 0 4/";
    String four = square.replace("6 8 0", "6 6 0") + ring;
    assertThat(solution(read(four)).counts().odd()).isEqualTo(2);
    String holed = ring.replace("3 3 4 5/", "").replace("3 1 5 4/", "");
    assertThat(fault(square.replace("6 8 0", "6 4 0") + holed))
        .startsWith("in:9: ")
        .contains("on one side of edge v4–v1 is no triangle");
    String frame = "OFF/6 6 0/0 0 0/9 0 0/0 9 0/2 2 0/4 2 0/2 4 0/";
    assertThat(fault(frame + "3 0 1 4/3 0 4 3/3 1 2 5/3 1 5 4/3 2 0 3/3 2 3 5/"))
        .contains(
            ", as at a hole: there are 2 rims; read it by --as region; read its points alone with"
                + " --as points");
    String gone = "OFF/5 3 0/0 0 0/9 0 0/0 9 0/2 2 0/3 3 0/3 0 1 3/3 1 2 3/3 2 0 3/";
    assertThat(fault(gone)).startsWith("in:7: ").contains("vertex v4 has fewer than two edges");
    assertThat(read(FAN, Choice.NONE.as(Domain.POLYGON)).notes())
        .containsExactly(
            "Line 11: its triangles are no triangulation of its polygon: edge v0–v3 is on the rim"
                + " and no side; only its points are read");
  }

  @Test
  void the_points_alone_are_read_where_that_is_asked_for() throws IOException {
    String twice = FAN.replace("3 3 0 4", "3 1 0 4");
    PointDocument read = read(twice, Choice.NONE.as(Domain.SITES));
    assertThat(read.points().size()).isEqualTo(5);
    assertThat(read.solution(Progress.NONE)).isEmpty();
    assertThat(read.notes())
        .containsExactly(
            "Line 11: its triangles are no triangulation of its sites: the triangle is there"
                + " already, on line 8; only its points are read");
    assertThat(catchThrowableOfType(NoTriangulation.class, () -> read(twice))).isNotNull();
  }

  @Test
  void a_missing_triangle_of_three_edges_is_a_hole() {
    String holed =
        "OFF/6 6 0/0 0 0/20 0 0/9 20 0/8 5 0/10 5 0/9 7 0/"
            + "3 0 1 4/3 0 4 3/3 1 2 5/3 1 5 4/3 2 0 3/3 2 3 5/";
    assertThat(fault(holed)).contains("on one side of an edge of this triangle is none");
  }

  @Test
  void triangles_without_their_vertices_are_refused() throws IOException {
    Solution written = made(random(Domain.SITES, 5));
    Path ele = folder.resolve("m.1.ele");
    DataFile.write(ele, FileEnding.ELE, Drawing.of(written), Progress.NONE);
    assertThat(solution(PointFile.read(ele, Progress.NONE)).counts()).isEqualTo(written.counts());
    Path node = folder.resolve("m.1.node");
    Files.writeString(node, Files.readString(node).replace("19 2 0 0", "20 2 0 0"));
    assertThat(elementFault(ele)).startsWith(node + ":20: the file ends after 19 of 20 vertices");
    Files.delete(node);
    assertThat(elementFault(ele))
        .startsWith(ele + ":1: the vertices of the triangles stand in m.1.node, and there is no");
    Files.writeString(node, "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
    Files.writeString(ele, "1 3 0\n1 1 2 4\n");
    assertThat(elementFault(ele)).startsWith(ele + ":2: there is no vertex 4; correct the triang");
    Files.writeString(ele, "2 3 0\n1 1 2 3\n");
    assertThat(elementFault(ele)).startsWith(ele + ":2: the file ends after 1 of 2 triangles");
    Files.writeString(ele, "1 6 0\n1 1 2 3 4 5 6\n");
    assertThat(elementFault(ele)).startsWith(ele + ":1: the triangles have 6 nodes each");
    Files.writeString(ele, "1 3 1\n1 3 2 1 7.5\n");
    PointDocument read = PointFile.read(ele, Progress.NONE);
    assertThat(read.notes()).containsExactly("Attributes of the triangles are left out");
    assertThat(solution(read).triangulation().edgeCount()).isEqualTo(3);
  }

  private static String elementFault(Path file) {
    return catchThrowableOfType(BadInputException.class, () -> PointFile.read(file, Progress.NONE))
        .getMessage();
  }

  @Test
  void edges_beside_their_vertices_are_told_by_their_marks() throws IOException {
    Files.writeString(folder.resolve("d.node"), "5 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 2\n");
    String edges = "7 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 5 1\n5 5 1 1\n6 2 5 0\n7 3 5 0\n";
    Path file = Files.writeString(folder.resolve("d.edge"), edges);
    assertThat(solution(PointFile.read(file, Progress.NONE)).instance().domain())
        .isEqualTo(Domain.POLYGON);
    Files.writeString(file, edges.replace("6 2 5", "6 2 4"));
    assertThat(elementFault(file))
        .startsWith(file + ":")
        .contains("its edges are no triangulation of its polygon: on one side of edge");
    Files.writeString(file, edges.replace("6 2 5", "6 2 6"));
    assertThat(elementFault(file)).startsWith(file + ":7: there is no vertex 6; correct the edge");
    Files.writeString(file, edges.replace("7 1\n1", "6 1\n1"));
    assertThat(elementFault(file)).startsWith(file + ":8: the file goes on behind its last edge");
    Files.delete(folder.resolve("d.node"));
    assertThat(elementFault(file))
        .startsWith(file + ":1: the vertices of the edges stand in d.node, and there is no such");
  }

  /** Whatever is accepted has exactly the triangles of the file. */
  @Test
  void changed_triangles_are_refused_or_read_as_they_are() throws IOException {
    Random random = new Random(11);
    int accepted = 0;
    for (int round = 0; round < 3000; round++) {
      int n = 4 + random.nextInt(4);
      double[] pairs = random.ints(2L * n, 0, 4).asDoubleStream().toArray();
      List<Set<Integer>> triangles = new ArrayList<>();
      StringBuilder text = new StringBuilder();
      int count = n - 2 + random.nextInt(3);
      for (int v = 0; v < n; v++) {
        text.append(pairs[2 * v]).append(' ').append(pairs[2 * v + 1]).append(" 0/");
      }
      for (int t = 0; t < count; t++) {
        int[] corners = random.ints(0, n).distinct().limit(3).toArray();
        triangles.add(Set.of(corners[0], corners[1], corners[2]));
        text.append("3 " + corners[0] + " " + corners[1] + " " + corners[2] + "/");
      }
      try {
        PointDocument read = read("OFF/" + n + " " + count + " 0/" + text);
        Solution solution = solution(read);
        assertThat(solution.triangulation().triangleCount()).isEqualTo(count);
        if (read.points().equals(Points.ofPairs(pairs))) {
          assertThat(triangles).hasSameElementsAs(triangles(solution.triangulation()));
        }
        assertVerified(solution);
        accepted++;
      } catch (NoTriangulation e) {
        assertThat(e.line()).isBetween(2, 1 + 1 + n + count);
      }
    }
    assertThat(accepted).isGreaterThan(40);
  }

  private static Set<Set<Integer>> triangles(Triangulation of) {
    Set<Set<Integer>> triangles = new HashSet<>();
    int[] corners = of.triangles();
    for (int i = 0; i < corners.length; i += 3) {
      triangles.add(Set.of(corners[i], corners[i + 1], corners[i + 2]));
    }
    return triangles;
  }

  @Test
  void no_cut_off_file_fails_in_another_way() throws IOException {
    for (int end = 5; end < FAN.length(); end++) {
      try {
        assertThat(read(FAN.substring(0, end)).points().size()).isPositive();
      } catch (BadInputException e) {
        assertThat(e).hasMessageMatching(".*in.off:\\d+: .+; .+");
      }
    }
  }
}
