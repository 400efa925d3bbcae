package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What the verbs make of a file that holds a triangulation of another program. */
class MeshCommandsTest {
  private static final String NODES = "5 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 2\n";
  private static final String TRIANGLES = "4 3 0\n1 1 2 5\n2 2 3 5\n3 3 4 5\n4 4 1 5\n";

  @TempDir private Path folder;
  private Path mesh;

  @BeforeEach
  void write() throws IOException {
    Files.writeString(folder.resolve("m.node"), NODES);
    mesh = Files.writeString(folder.resolve("m.ele"), TRIANGLES);
  }

  @Test
  void its_result_is_verified() {
    Path result = folder.resolve("r.json");
    assertThat(CliRun.of("convert", mesh, "-o", result).done().err()).isEmpty();
    assertThat(CliRun.of("verify", result, "--input", mesh).done().out())
        .contains("verified: 5 sites triangulated by an unknown method, 1 even, 4 odd");
  }

  @Test
  void its_triangulation_is_verified_without_a_result() throws IOException {
    for (String name : new String[] {"a.off", "a.obj", "a.ele", "a.edge", "a.instance.json"}) {
      Path file = folder.resolve(name);
      CliRun.of("convert", mesh, "-o", file);
      assertThat(CliRun.of("verify", file, "--input", mesh).done().out())
          .isEqualTo(
              file + ": verified: 5 sites triangulated by an unknown method, 1 even, 4 odd\n");
    }
    Path off = folder.resolve("a.off");
    assertThat(CliRun.withInput(Files.readString(off), "verify", "-", "--json").done().out())
        .contains("\"verdict\":\"true\"");
    Files.writeString(folder.resolve("m.node"), NODES.replace("5 1 2", "5 2 1"));
    CliRun other = CliRun.of("verify", off, "--input", mesh);
    assertThat(other.status()).isEqualTo(4);
    assertThat(other.err()).startsWith(off + ": ").contains(mesh.toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"ele", "edge"})
  void standard_output_says_that_the_vertices_are_left_out(String format) {
    CliRun run = CliRun.of("convert", mesh, "-o", "-", "--to", format);
    assertThat(run.status()).isEqualTo(CommandLineProgram.DONE);
    assertThat(run.err())
        .isEqualTo("-: the vertices are left out; they belong beside it, use --to node\n");
    assertThat(CliRun.of("convert", mesh, "-o", "-", "--to", "off").done().err()).isEmpty();
  }

  @Test
  void triangles_that_are_no_triangulation_are_false() throws IOException {
    Files.writeString(mesh, TRIANGLES.replace("1 1 2 5", "1 1 2 3"));
    CliRun run = CliRun.of("verify", mesh);
    assertThat(run.status()).isEqualTo(4);
    assertThat(run.out()).isEmpty();
    assertThat(run.err())
        .matches(mesh + ":\\d+: its triangles are no triangulation of its sites: [^\n]+\n");
    assertThat(CliRun.of("verify", mesh, "--json").out()).contains("\"verdict\":\"false\"");
    assertThat(CliRun.of("verify", mesh, "--quiet").err()).isEmpty();
  }

  @Test
  void one_of_several_triangulations_has_to_be_chosen() throws IOException {
    Path two =
        Files.writeString(
            folder.resolve("two.json"),
            "{\"content_type\": \"CGSHOP2026_Instance\", \"points_x\": [0,4,4,0],"
                + " \"points_y\": [0,0,4,4], \"triangulations\": [[[0,2]],[[1,3]]]}");
    assertThat(CliRun.of("verify", two).err())
        .startsWith(two + ": CG:SHOP with 2 shapes; choose one by --pick N\n")
        .contains("2: triangulation 2, 4 sites, triangulated");
    assertThat(CliRun.of("verify", two, "--pick", 2).done().out()).contains("verified");
  }

  @Test
  void a_file_of_points_alone_cannot_be_verified() {
    CliRun run = CliRun.of("verify", folder.resolve("m.node"));
    assertThat(run.status()).isEqualTo(3);
    assertThat(run.err())
        .isEqualTo(
            folder.resolve("m.node")
                + ": the format is Triangle, and it holds no triangulation; triangulate it"
                + " first\n");
    assertThat(CliRun.withInput("0 0\n1 0\n0 1\n", "verify", "-").err())
        .isEqualTo("-: the format is Text, and it holds no triangulation; triangulate it first\n");
  }

  @ParameterizedTest
  @ValueSource(strings = {"a.off", "a.obj", "a.ele", "a.json", "a.instance.json"})
  void a_format_that_can_hold_it_keeps_it(String name) throws IOException {
    Path file = folder.resolve(name);
    Path again = folder.resolve("again.json");
    CliRun.of("convert", mesh, "-o", file);
    CliRun.of("convert", file, "-o", again).done();
    assertThat(Files.readString(again))
        .contains("\"algorithm\": \"unknown\"", "\"even\": 1,", "[0, 1, \"boundary\"]");
  }

  @Test
  void a_format_that_cannot_says_so() {
    Path text = folder.resolve("a.txt");
    assertThat(CliRun.of("convert", mesh, "-o", text).err())
        .contains("a.txt: holds the points alone; the triangulation is left out, use .json");
  }

  @Test
  void its_points_are_triangulated_anew_and_that_is_said() {
    CliRun run = CliRun.of("triangulate", mesh);
    assertThat(run.out()).contains("5 sites, delaunay: 8 edges");
    assertThat(run.err())
        .isEqualTo(mesh + ": its triangulation is left out; --algorithm as-read takes it\n");
  }

  @Test
  void its_triangulation_can_be_flipped_and_optimized() throws IOException {
    Files.writeString(folder.resolve("m.node"), NODES.replace("5 1 2", "5 2 1"));
    Path result = folder.resolve("r.json");
    assertThat(CliRun.of("triangulate", mesh, "--algorithm", "as-read").done().out())
        .contains("5 sites, unknown: 8 edges");
    for (String post : new String[] {"--flip", "--optimize=even"}) {
      CliRun.of("triangulate", mesh, "--algorithm", "as-read", post, "-o", result).done();
      assertThat(CliRun.of("verify", result).done().out()).contains("by an unknown method");
      CliRun.of("triangulate", result, "--algorithm", "as-read").done();
    }
    CliRun none = CliRun.of("triangulate", folder.resolve("m.node"), "--algorithm", "as-read");
    assertThat(none.err())
        .endsWith(
            "m.node: there is no triangulation in it, as --algorithm as-read takes; leave the"
                + " option out\n");
  }

  @Test
  void points_alone_are_read_where_its_triangles_are_wrong() throws IOException {
    Files.writeString(mesh, TRIANGLES.replace("4 4 1 5", "4 4 1 2"));
    CliRun wrong = CliRun.of("convert", mesh, "-o", folder.resolve("r.json"));
    assertThat(wrong.status()).isEqualTo(CommandLineProgram.BAD_INPUT);
    assertThat(wrong.err())
        .startsWith(mesh + ":5: its triangles are no triangulation of its sites: the triangle lies")
        .endsWith("; read its points alone with --as points\n");
    assertThat(CliRun.of("triangulate", mesh, "--as", "points").err())
        .contains("Line 5: its triangles are no triangulation", "only its points are read");
  }
}
