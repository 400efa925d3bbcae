package dct.experiment.generate;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/**
 * What is generated from a seed never changes: the coordinates of each shape, bit by bit, for two
 * numbers of vertices and seeds.
 */
class SameOnEveryMachineTest {

  @Test
  void polygons() {
    String hashes =
        Arrays.stream(PolygonShape.values())
            .map(shape -> line(shape.word(), hash(shape, 20, 7), hash(shape, 300, 8)))
            .collect(Collectors.joining());
    assertThat(hashes)
        .isEqualTo(
            """
        two-opt 6ec75301 3c0d1d01
        steady-growth fc0d5301 94f51d01
        space-partitioning 3e8d5301 ce171d01
        star-shaped 84535301 57251d01
        x-monotone d0e55301 dc811d01
        convex 8d4ff301 7e523601
        orthogonal 955b8b01 cb267501
        comb 722d8b01 490f3501
        spiral e88b4b01 10f96501
        spanning-tree d59af301 562eed01
        tour 61d35301 30571d01
        bent-edges 99425462 e6a9b464
        """);
  }

  @Test
  void sites() {
    String hashes =
        Arrays.stream(SiteShape.values())
            .map(shape -> line(shape.word(), hash(shape, 20, 7), hash(shape, 300, 8)))
            .collect(Collectors.joining());
    assertThat(hashes)
        .isEqualTo(
            """
        uniform f9775301 d7d31d01
        disk 64328b01 da0bfd01
        clusters a1f8cb01 dbb52501
        lattice 1c465b01 fa2fad01
        jittered-lattice 5986e301 bbb4bd01
        circle db429b01 66bb8d01
        lines 289c1b01 d0d7ad01
        """);
  }

  private static String line(String word, int small, int large) {
    return "%s %08x %08x\n".formatted(word, small, large);
  }

  private static int hash(PolygonShape shape, int n, long seed) {
    return hash(shape.generate(n, seed).points());
  }

  private static int hash(SiteShape shape, int n, long seed) {
    return hash(shape.generate(n, seed));
  }

  private static int hash(Points points) {
    double[] coordinates = new double[2 * points.size()];
    for (int v = 0; v < points.size(); v++) {
      coordinates[2 * v] = points.x(v);
      coordinates[2 * v + 1] = points.y(v);
    }
    return Arrays.hashCode(coordinates);
  }
}
