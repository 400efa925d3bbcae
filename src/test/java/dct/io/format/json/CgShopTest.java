package dct.io.format.json;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.SiteShape;
import dct.io.DataFile;
import dct.io.FileEnding;
import dct.io.PointDocument;
import dct.io.PointFile;
import dct.io.format.Choice;
import dct.io.format.Columns;
import dct.io.format.Drawing;
import dct.io.format.SeveralShapes;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.text.BadInputException;
import dct.problem.Comparison;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Files of the challenge CG:SHOP; an apostrophe stands for a quotation mark. */
class CgShopTest {
  private static final String SQUARE =
      "{'content_type':'CGSHOP2026_Instance','instance_uid':'u',\n'points_x':[0,9,0,9],\n"
          + "'points_y':[0,0,9,9],\n'triangulations':[[\n[0,3]],\n[[2,1]]]}";

  private static ByteArrayInputStream stream(String text) {
    return new ByteArrayInputStream(text.replace('\'', '"').getBytes(StandardCharsets.UTF_8));
  }

  private static Shapes shapes(String text) {
    try {
      return PointFile.shapes("in", stream(text), Columns.TOLD_BY_CONTENT);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static PointDocument read(String text, Choice choice) {
    try {
      return PointFile.read("in", stream(text), choice);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String fault(String text, Choice choice) {
    return catchThrowableOfType(BadInputException.class, () -> read(text, choice)).getMessage();
  }

  private static Solution solution(PointDocument read) {
    return read.solution(Progress.NONE).orElseThrow();
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      delimiter = '|',
      value = {
        "{'type':'Instance_CGSHOP2022','id':'i','x':[0,4,4],'y':[0,0,4],'edge_i':[0],'edge_j':[1]}"
            + " | i, 3 sites",
        "{'type':'CGSHOP2023_Solution','instance':'i','polygons':[[{'x':{'num':3,'den':2},'y':0},"
            + "{'x':4,'y':{'num':'8','den':'4'}},{'x':0,'y':9}],[{'x':0,'y':0},{'x':1,'y':0},"
            + "{'x':1,'y':1}]]} | ring of 3 vertices; ring of 3 vertices",
        "{'type':'cgshop2024_instance','instance_name':'n','container':{'x':[0,9,9],'y':[0,0,9]},"
            + "'items':[{'value':5,'x':[0,1,1,0],'y':[0,0,1,1]}]}"
            + " | n, ring of 3 vertices; n, ring of 4 vertices",
        "{'content_type':'CG_SHOP_2025_Solution','instance_uid':'u','steiner_points_x':['1/2',3],"
            + "'steiner_points_y':['-7/4','2.5'],'edges':[[0,1]]} | Steiner points, 2 sites",
      })
  void forms(String text, String described) {
    List<String> found = shapes(text).shapes().stream().map(Shape::description).toList();
    assertThat(String.join("; ", found)).isEqualTo(described);
  }

  @Test
  void fractions_are_read_exactly_or_that_is_said() {
    String text =
        "{'content_type':'CG_SHOP_2025_Solution','steiner_points_x':['1/2','1/3',"
            + "{'num':'36893488147419103233','den':4}],'steiner_points_y':['-6/-4','7',"
            + "'1/36893488147419103232']}";
    Points points = shapes(text).shapes().get(0).points();
    assertThat(points.xs()).containsExactly(0.5, 1.0 / 3, 0x1p63);
    assertThat(points.ys()).containsExactly(1.5, 7, 0x1p-65);
    assertThat(shapes(text).notes())
        .containsExactly("2 coordinates are fractions that no double equals; the nearest is read");
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      delimiter = '|',
      value = {
        "{'type':'Solution','instance_name':'us-7','edges':[{'in':0,'out':1}]} | us-7",
        "{'type':'Solution_CGSHOP2022','instance':'vis-3','num_colors':2,'colors':[0,1]} | vis-3",
        "{'content_type':'CGSHOP2026_Solution','instance_uid':'rirs','flips':[[[[1,2]]]]} | rirs",
        "{'content_type':'CG_SHOP_2025_Solution','instance_uid':'o','steiner_points_x':[],"
            + "'steiner_points_y':[],'edges':[[0,1]]} | o",
      })
  void a_solution_without_points_names_its_instance(String text, String instance) {
    assertThat(fault(text, Choice.NONE))
        .isEqualTo(
            "in:1: a solution of CG:SHOP without points of its own; open its instance " + instance);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{'meta':{},'name':'s','starts':[[0,0],[1,1]],'targets':[[2,1],[0,3]],'obstacles':[]}",
        "{'instance':'s','steps':[{'0':'E'},{'1':'N'}]}",
      })
  void robots_that_move_are_no_points(String text) {
    assertThat(fault(text, Choice.NONE))
        .isEqualTo(
            "in:1: this is CG:SHOP 2021, robots that move on a grid, and nothing to triangulate;"
                + " open a file of another year");
  }

  @Test
  void one_of_several_triangulations_is_picked_its_hull_may_be_left_out() {
    SeveralShapes several =
        catchThrowableOfType(SeveralShapes.class, () -> read(SQUARE, Choice.NONE));
    assertThat(several.shapes().shapes()).hasSize(2);
    assertThat(several.shapes().shapes().get(1).description())
        .isEqualTo("triangulation 2, 4 sites, triangulated");
    Solution second = solution(read(SQUARE, Choice.NONE.picking(2)));
    assertThat(second.triangulation().edgeCount()).isEqualTo(5);
    assertThat(second.triangulation().edgeBetween(1, 2)).isPresent();
    PointDocument points = read(SQUARE, Choice.NONE.as(Domain.SITES));
    assertThat(points.points().size()).isEqualTo(4);
    assertThat(points.solution(Progress.NONE)).isEmpty();
    assertThat(points.notes())
        .containsExactly("Only the points are read, and none of their 2 triangulations");
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      delimiter = '|',
      value = {
        "[0,3]|[0,4]|5: its edges are no triangulation of its sites: there is no vertex v4",
        "[0,3]|[0,-1]|5: its edges are no triangulation of its sites: there is no vertex v-1",
        "[0,3]|[3,3]|5: its edges are no triangulation of its sites: the edge leads from vertex v3",
        "[0,3]|[0,3],[3,0]|5: its edges are no triangulation of its sites: edge v0–v3 lies on",
        "[0,3]|[0,3],[1,2]|5: its edges are no triangulation of its sites: on one side of edge",
        "[0,3]|[0,1]|5: its edges are no triangulation of its sites: on one side of edge",
        "[0,3]|[0,2.5]|5: an edge names a point by a fraction; write whole numbers",
        "[0,9,0,9]|[0,9,0]|6: there are 3 x, but 4 y; give as many of both",
        "[0,9,0,9]|[0,9,0,'1/0']|2: `1/0` is no finite number",
        "points_x':[0,9|points_x':[0,0|3: its edges are no triangulation of its sites: two sites",
      })
  void what_is_wrong_is_said_with_its_line(String from, String to, String fault) {
    String text = SQUARE.replace(from, to);
    Choice choice = text.contains("[[2,1]]") ? Choice.NONE.picking(1) : Choice.NONE;
    assertThat(fault(text, choice)).startsWith("in:" + fault.replace('`', '"'));
  }

  @Test
  void triangulations_have_to_be_lists_of_lists() {
    String text = SQUARE.replace("[[\n[0,3]],\n[[2,1]]]", "[[0,3]]");
    assertThat(fault(text, Choice.NONE))
        .startsWith("in:4: the triangulations are not lists of edges; write [[[u, v], …], …]");
  }

  @Test
  void what_is_written_comes_back() throws IOException {
    for (int seed = 0; seed < 30; seed++) {
      double[] pairs = pairs(SiteShape.CLUSTERS.generate(5 + 4 * seed, seed));
      Instance instance = Instance.of(Domain.SITES, "x", Points.ofPairs(pairs), Progress.NONE);
      Solution made = Solution.of(instance, Method.DELAUNAY, Progress.NONE);
      Solution flipped = made.flipped(Progress.NONE);
      requireSame(PointFile.read("in", written(made), Choice.NONE), made);
      requireSame(PointFile.read("in", written(flipped), Choice.NONE.picking(1)), made);
      requireSame(PointFile.read("in", written(flipped), Choice.NONE.picking(2)), flipped);
    }
  }

  @Test
  void the_flips_of_a_solution_are_carried_out_in_the_instance_beside_it(@TempDir Path folder)
      throws IOException {
    double[] pairs = pairs(SiteShape.CLUSTERS.generate(40, 3));
    Instance instance = Instance.of(Domain.SITES, "x", Points.ofPairs(pairs), Progress.NONE);
    Solution flipped = Solution.of(instance, Method.DELAUNAY, Progress.NONE).flipped(Progress.NONE);
    Path solution = folder.resolve("some.solution.json");
    Drawing drawing = Drawing.of(flipped);
    DataFile.write(solution, FileEnding.SOLUTION, drawing, Progress.NONE);
    assertThatThrownBy(() -> PointFile.read(solution, Choice.NONE, Progress.NONE))
        .hasMessageContaining("open its instance x");
    Path beside = folder.resolve("x.json");
    DataFile.write(beside, FileEnding.INSTANCE, drawing, Progress.NONE);
    PointDocument first = PointFile.read(solution, Choice.NONE.picking(1), Progress.NONE);
    requireSame(first, flipped);
    assertThat(solution(first).flips().orElseThrow().flips())
        .isEqualTo(flipped.flips().orElseThrow().flips());
    requireSame(PointFile.read(solution, Choice.NONE.picking(2), Progress.NONE), flipped);
    Files.writeString(solution, Files.readString(solution).replaceFirst("\\[\\[\\d+, ", "[[99, "));
    assertThatThrownBy(() -> PointFile.read(solution, Choice.NONE.picking(1), Progress.NONE))
        .hasMessageContaining("flip 1 is impossible: there is no edge v99");
    Files.writeString(solution, Files.readString(solution).replaceFirst("\\], \\[\\]\\]", "]]"));
    assertThatThrownBy(() -> PointFile.read(solution, Choice.NONE, Progress.NONE))
        .hasMessageContaining("there are flips for 1 triangulations, but the instance has 2");
  }

  private static double[] pairs(Points points) {
    double[] pairs = new double[2 * points.size()];
    Arrays.setAll(pairs, i -> Math.rint(i % 2 == 0 ? points.x(i / 2) : points.y(i / 2)));
    return pairs;
  }

  private static ByteArrayInputStream written(Solution solution) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    DataFile.write(out, FileEnding.INSTANCE, Drawing.of(solution), Progress.NONE);
    return new ByteArrayInputStream(out.toByteArray());
  }

  private static void requireSame(PointDocument read, Solution written) {
    assertThat(read.points()).isEqualTo(written.instance().points());
    assertThat(Comparison.of(solution(read).triangulation(), written.triangulation()).isSame())
        .isTrue();
  }
}
