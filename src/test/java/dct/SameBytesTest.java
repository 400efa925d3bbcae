package dct;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.degree.best.BestTriangulation;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import java.io.File;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * The same input and options give the same result, whatever the machine.
 *
 * <p>The input is a convex polygon of 1,200 vertices, whose table of 720,000 pairs takes about 30
 * MB: with a heap of 64 MB a program that looks at the free memory would not fill it.
 */
class SameBytesTest {
  private static final int VERTICES = Integer.getInteger("dct.test.vertices", 1200);

  private static double[] circle() {
    double[] pairs = new double[2 * VERTICES];
    for (int k = 0; k < VERTICES; k++) {
      pairs[2 * k] = 1000 * StrictMath.cos(2 * Math.PI * k / VERTICES);
      pairs[2 * k + 1] = 1000 * StrictMath.sin(2 * Math.PI * k / VERTICES);
    }
    return pairs;
  }

  /** Prints the corners of the best odd triangulation. */
  static final class Program {
    private Program() {}

    /** Run as a process of its own. */
    public static void main(String[] args) {
      System.out.println(Arrays.toString(bestCorners()));
    }
  }

  private static int[] bestCorners() {
    return BestTriangulation.of(
            SimplePolygon.of(Points.ofPairs(circle()), Progress.NONE),
            ParityGoal.allOdd(VERTICES),
            SearchLimits.DEFAULT,
            Progress.NONE)
        .triangulation()
        .triangles();
  }

  private static String printed(String... options) throws Exception {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of(options));
    String classPath = placeOf(Progress.class) + File.pathSeparator + placeOf(Program.class);
    command.addAll(List.of("-cp", classPath, Program.class.getName()));
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    process.waitFor();
    return out.replaceAll("Picked up .*\\R", "");
  }

  private static Path placeOf(Class<?> type) throws URISyntaxException {
    return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
  }

  @Test
  void neitherTheHeapNorTheCoresMakeADifference() throws Exception {
    String usual = printed("-Xmx1g");
    assertThat(usual).startsWith("[").endsWith("]\n");
    assertThat(printed("-Xmx64m")).isEqualTo(usual);
    assertThat(printed("-Xmx1g", "-XX:ActiveProcessorCount=1")).isEqualTo(usual);
  }

  @Test
  void aHeapThatIsTooSmallGivesNoOtherResult() throws Exception {
    assertThat(printed("-Xmx24m", "-Ddct.test.vertices=100000"))
        .contains("OutOfMemoryError")
        .doesNotContain("[");
  }

  @Test
  void aWarmProcessGivesWhatAColdOneGives() {
    int[] cold = bestCorners();
    for (int run = 0; run < 3; run++) {
      assertThat(bestCorners()).isEqualTo(cold);
    }
  }
}
