package dct.core.degree.colour;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.bound.SmallSets;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.testing.RandomSets.Family;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class EmptyFanTest {

  private static List<Family> families() {
    return SmallSets.families();
  }

  @ParameterizedTest
  @MethodSource("families")
  void findsEveryEmptyTriangleOnce(Family family) {
    for (long seed = 0; seed < 6; seed++) {
      Sites sites = family.make(5 + (int) (3 * seed), seed);
      Triangulation start = Delaunay.triangulate(sites, Progress.NONE);
      if (start.triangleCount() > 0) {
        HullRing ring = HullRing.of(start);
        for (int k = 0; k < ring.size(); k++) {
          check(ring, k, "%s, seed %d, position %d".formatted(family, seed, k));
        }
      }
    }
  }

  private static void check(HullRing ring, int k, String name) {
    EmptyFan fan = EmptyFan.of(ring, k, Integer.MAX_VALUE).orElseThrow();
    Set<List<Integer>> found = new HashSet<>();
    for (int j = 0; j < fan.size(); j++) {
      for (int place = fan.firstPartner(j); place < fan.firstPartner(j + 1); place++) {
        found.add(List.of(fan.site(fan.partner(place)), fan.site(j)));
      }
    }
    assertThat(found).as(name).isEqualTo(emptyTriangles(ring.points(), ring.site(k)));
    assertThat(fan.triangles()).as(name).isEqualTo(found.size());
  }

  private static Set<List<Integer>> emptyTriangles(Points points, int hub) {
    Set<List<Integer>> pairs = new HashSet<>();
    for (int a = 0; a < points.size(); a++) {
      for (int b = 0; b < points.size(); b++) {
        if (points.orient(hub, a, b) > 0 && isEmpty(points, hub, a, b)) {
          pairs.add(List.of(a, b));
        }
      }
    }
    return pairs;
  }

  private static boolean isEmpty(Points points, int a, int b, int c) {
    for (int d = 0; d < points.size(); d++) {
      boolean isInside =
          points.orient(a, b, d) >= 0 && points.orient(b, c, d) >= 0 && points.orient(c, a, d) >= 0;
      if (isInside && d != a && d != b && d != c) {
        return false;
      }
    }
    return true;
  }

  @Test
  void givesUpAtTooManyTriangles() {
    Sites square = Sites.of(Points.ofPairs(0, 0, 1, 0, 1, 1, 0, 1), Progress.NONE);
    HullRing ring = HullRing.of(Delaunay.triangulate(square, Progress.NONE));
    assertThat(EmptyFan.of(ring, 0, 3)).isPresent();
    assertThat(EmptyFan.of(ring, 0, 2)).isEmpty();
  }
}
