package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The verbs on a region with holes, a site and a fixed edge. */
class RegionCommandsTest {
  private static final String PLATE = "samples/plate_region.txt";

  @TempDir private Path folder;

  private static JsonObject json(CliRun run) {
    return JsonParser.parseString(run.out()).getAsJsonObject();
  }

  @Test
  void checkSaysWhatThereIs() {
    assertThat(CliRun.of("check", PLATE).done().out())
        .isEqualTo(PLATE + ": a region with 16 vertices, 2 holes, 1 site and 1 fixed edge\n");
    JsonObject found = json(CliRun.of("check", PLATE, "--json").done());
    assertThat(found.get("kind").getAsString()).isEqualTo("region");
    assertThat(found.get("holes").getAsInt()).isEqualTo(2);
    assertThat(found.get("fixed").getAsInt()).isEqualTo(1);
  }

  @Test
  void theSummaryHasTheSizesOfTheRings() {
    JsonObject summary = json(CliRun.of("triangulate", PLATE, "--flip", "--json").done());
    assertThat(summary.get("ringSizes").toString()).isEqualTo("[6,5,4]");
    assertThat(summary.get("boundary").getAsInt()).isEqualTo(15);
    assertThat(summary.get("triangles").getAsInt()).isEqualTo(19);
    assertThat(summary.get("oddLowerBound").getAsInt())
        .isLessThanOrEqualTo(summary.get("odd").getAsInt());
  }

  @Test
  void delaunayIsForSites() {
    CliRun run = CliRun.of("triangulate", PLATE, "--algorithm", "delaunay");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("--algorithm delaunay is none for a region, use monotone,");
  }

  @Test
  void convertGoesRoundAndRound() throws IOException {
    String text = Files.readString(Path.of(PLATE)).replaceFirst("#.*\n", "");
    Path again = folder.resolve("again.txt");
    for (String ending : new String[] {".txt", ".json", ".poly"}) {
      Path file = folder.resolve("plate" + ending);
      CliRun.of("convert", PLATE, "-o", file).done();
      CliRun.of("convert", file, "--as", "region", "-o", again).done();
      assertThat(again).hasContent(text);
    }
    CliRun refused = CliRun.of("convert", PLATE, "-o", folder.resolve("plate.wkt"));
    assertThat(refused.status()).isEqualTo(1);
    assertThat(refused.err()).contains("it holds no fixed edges inside a region; choose .txt");
  }

  @Test
  void theListCountsRegions() {
    String text =
        "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 0), (4 1, 5 1, 5 2, 4 1)), ((0 20, 9 20, 9 29)))";
    assertThat(CliRun.withInput(text, "convert", "-", "--list", "--as", "region").done().out())
        .isEqualTo("1: with 1 hole, ring of 3 vertices\n2: ring of 3 vertices\n");
    assertThat(CliRun.withInput(text, "check", "-", "--as", "region", "--pick", "2").done().out())
        .contains("a region with 3 vertices, 0 holes");
  }

  @Test
  void aNameOfAnotherKindIsRefused() {
    CliRun run = CliRun.of("convert", PLATE, "-o", folder.resolve("a_polygonbased.txt"));
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("but this is region; name it ").contains("a_region.txt");
  }

  /** The inside is filled, the holes are not. */
  @Test
  void picturesHaveHoles() throws IOException {
    Path file = folder.resolve("plate.png");
    for (String verb : new String[] {"triangulate", "convert"}) {
      CliRun.of(verb, PLATE, "-o", file, "--no-counts", "--size", "600px").status();
      BufferedImage picture = ImageIO.read(file.toFile());
      int outside = at(picture, 0.98, 0.05);
      assertThat(at(picture, 0.21, 0.3)).as("in a hole, %s", verb).isEqualTo(outside);
      assertThat(at(picture, 0.6, 0.62)).as("in the other").isEqualTo(outside);
      assertThat(at(picture, 0.04, 0.5)).as("inside").isNotEqualTo(outside);
    }
  }

  private static int at(BufferedImage picture, double x, double y) {
    return picture.getRGB((int) (x * picture.getWidth()), (int) (y * picture.getHeight()));
  }

  /** A hole from side to side leaves two regions, which are listed as they are picked. */
  @Test
  void partsOfARegionAreListedAndPicked() {
    String text = "0 0\n9 0\n9 9\n0 9\nhole\n0 5\n5 4\n9 5\n5 6\nsites\n2 1\n";
    assertThat(CliRun.withInput(text, "convert", "-", "--list", "--touching", "split").done().out())
        .isEqualTo("1: ring of 5 vertices\n2: ring of 5 vertices\n");
    CliRun both = CliRun.withInput(text, "check", "-", "--touching", "split");
    assertThat(both.status()).isEqualTo(3);
    assertThat(both.err()).contains("choose one by --pick N");
    CliRun first = CliRun.withInput(text, "check", "-", "--touching", "split", "--pick", "1");
    assertThat(first.out())
        .isEqualTo("-: a region with 6 vertices, 0 holes, 1 site and 0 fixed edges\n");
    assertThat(first.err()).isEqualTo("-: Rings touch, and the region is split into 2\n");
    CliRun hair = CliRun.withInput(text, "triangulate", "-", "--touching", "hair", "--flip");
    assertThat(hair.status()).isZero();
  }
}
