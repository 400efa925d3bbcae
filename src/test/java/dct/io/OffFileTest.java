package dct.io;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OffFileTest {
  private final Points points = Points.of(new double[] {0, 4, 0.1, 1}, new double[] {0, 0, 0.5, 3});

  @Test
  void listsVerticesInOrderAndThenTriangles(@TempDir Path folder) throws Exception {
    Triangulation triangulation =
        Delaunay.triangulate(Sites.of(points, Progress.NONE), Progress.NONE);
    Path file = folder.resolve("t.off");
    OffFile.write(file, triangulation, Progress.NONE);
    int[] t = triangulation.triangles();
    List<String> expected =
        new ArrayList<>(
            List.of("OFF", "4 " + t.length / 3 + " 0", "0 0 0", "4 0 0", "0.1 0.5 0", "1 3 0"));
    for (int k = 0; k < t.length; k += 3) {
      expected.add("3 %d %d %d".formatted(t[k], t[k + 1], t[k + 2]));
    }
    assertThat(Files.readAllLines(file)).isEqualTo(expected).hasSizeGreaterThan(7);
  }

  @Test
  void pointsAloneHaveNoFaces(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("p.off");
    OffFile.write(file, points, Progress.NONE);
    assertThat(Files.readAllLines(file)).hasSize(6).element(1).isEqualTo("4 0 0");
  }
}
