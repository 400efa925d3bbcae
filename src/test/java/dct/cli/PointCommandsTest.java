package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import dct.io.PointDocument;
import dct.io.PointFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The verbs generate, convert and check. */
class PointCommandsTest {
  @TempDir Path folder;

  @Test
  void generate_writes_the_seeded_sites() {
    Path file = folder.resolve("x_pointbased.txt");
    Path json = folder.resolve("x.json");
    CliRun run =
        CliRun.of("generate", "points", "-n", 50, "--seed", 7, "-o", file, "-o", json).done();
    assertThat(run.out()).isEmpty();
    for (Path written : new Path[] {file, json}) {
      PointDocument document = PointFile.read(written);
      assertThat(document.points()).isEqualTo(RandomSites.uniform(50, 7));
      assertThat(document.declared()).contains(Domain.SITES);
    }
  }

  @Test
  void generate_prints_text_that_the_other_verbs_take() {
    CliRun run = CliRun.of("generate", "points", "-n", 30, "--shape", "uniform").done();
    assertThat(run.out().lines()).hasSize(31).startsWith("# kind: points");
    assertThat(CliRun.of("generate", "points", "-n", 30, "--seed", 1, "-o", "-")).isEqualTo(run);
    assertThat(CliRun.of("generate", "points", "-n", 30, "--seed", -1)).isNotEqualTo(run);
    assertThat(CliRun.withInput(run.out(), "check", "-").done().out())
        .isEqualTo("-: 30 usable sites\n");
    assertThat(CliRun.withInput(run.out(), "triangulate", "-", "--quiet").done().out()).isEmpty();
  }

  @Test
  void convert_goes_there_and_back() throws IOException {
    String text = "0 0\n4.5 0.25\n-1e-9 3\n";
    Path file = Files.writeString(folder.resolve("x_polygonbased.txt"), text);
    Path json = folder.resolve("x.json");
    Path back = folder.resolve("y_polygonbased.txt");
    CliRun.of("convert", file, "-o", json).done();
    assertThat(json)
        .hasContent("{\"kind\": \"polygon\", \"points\": [\n[0, 0],\n[4.5, 0.25],\n[-1e-9, 3]]}");
    CliRun.of("convert", json, "-o", back).done();
    assertThat(back).hasContent(text);
    assertThat(CliRun.of("convert", json, "-o", "-").done().out())
        .isEqualTo("# kind: polygon\n" + text);
    assertThat(CliRun.of("convert", json, "--as", "points", "-o", "-").done().out())
        .isEqualTo("# kind: points\n" + text);
  }

  @Test
  void convert_takes_points_that_are_no_polygon_and_adds_no_kind() {
    CliRun run = CliRun.withInput("0;0\n4;4\n4;0\n0;4", "convert", "-", "-o", "-").done();
    assertThat(run.out()).isEqualTo("0 0\n4 4\n4 0\n0 4\n");
    Path json = folder.resolve("x.json");
    CliRun.withInput(run.out(), "convert", "-", "-o", json).done();
    assertThat(json).hasContent("{\"points\": [\n[0, 0],\n[4, 4],\n[4, 0],\n[0, 4]]}");
  }

  @Test
  void convert_takes_the_points_of_a_whole_result() {
    Path result = folder.resolve("result.json");
    CliRun.withInput("0 0\n4 0\n0 4", "triangulate", "-", "-o", result).done();
    assertThat(CliRun.of("convert", result, "-o", "-").done().out())
        .isEqualTo("# kind: polygon\n0 0\n4 0\n0 4\n");
  }

  @Test
  void convert_draws() throws IOException {
    for (String kind : new String[] {"polygon", "points"}) {
      Path png = folder.resolve(kind + ".png");
      CliRun.withInput("0 0\n4 0\n0 4", "convert", "-", "--as", kind, "-o", png).done();
      assertThat(ImageIO.read(png.toFile()).getHeight()).isEqualTo(700);
    }
  }

  @Test
  void check_says_what_was_found() {
    assertThat(CliRun.withInput("0 0\n4 0\n0 4", "check", "-").done().out())
        .isEqualTo("-: a simple polygon with 3 vertices, counter-clockwise\n");
    assertThat(CliRun.withInput("0 0\n0 4\n4 0", "check", "-").done().out())
        .isEqualTo("-: a simple polygon with 3 vertices, clockwise\n");
    assertThat(
            CliRun.withInput("0 0\n4 0\n0 4\n0 0\n4 0", "check", "-", "--as", "points")
                .done()
                .out())
        .isEqualTo("-: 3 usable sites (2 duplicates merged)\n");
    assertThat(CliRun.withInput("0 0\n4 0\n0 4", "check", "-", "--quiet").done().out()).isEmpty();
  }
}
