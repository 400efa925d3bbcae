package dct.core.degree.colour;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.bound.SmallSets;
import dct.core.geometry.Points;
import dct.testing.RandomSets.Family;
import java.util.BitSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** All empty triangles at some sites, each once, against a look at every three sites. */
class AllTrianglesTest {
  private static final int NO_LIMIT = 100_000;

  private static List<Family> families() {
    return SmallSets.families();
  }

  @ParameterizedTest
  @MethodSource("families")
  void findsEveryEmptyTriangleOnce(Family family) {
    for (long seed = 0; seed < 6; seed++) {
      Points points = family.make(4 + 3 * (int) seed, seed).points();
      Random random = new Random(seed);
      for (int share = 0; share < 4; share++) {
        BitSet at = new BitSet();
        for (int v = 0; v < points.size(); v++) {
          at.set(v, random.nextInt(3) >= share);
        }
        check(points, at, "%s, seed %d, at %s".formatted(family, seed, at));
      }
    }
  }

  private static void check(Points points, BitSet at, String name) {
    AllTriangles all = AllTriangles.of(points, at, NO_LIMIT, Progress.NONE).orElseThrow();
    Set<String> found = new TreeSet<>();
    for (int t = 0; t < all.count(); t++) {
      int a = all.corner(3 * t);
      int b = all.corner(3 * t + 1);
      int c = all.corner(3 * t + 2);
      assertThat(points.orient(a, b, c)).as(name).isPositive();
      found.add(name(a, b, c));
    }
    assertThat(found).as(name).hasSize(all.count()).isEqualTo(emptyTriangles(points, at));
  }

  private static String name(int... corners) {
    return new TreeSet<>(List.of(corners[0], corners[1], corners[2])).toString();
  }

  private static Set<String> emptyTriangles(Points points, BitSet at) {
    Set<String> expected = new TreeSet<>();
    for (int a = 0; a < points.size(); a++) {
      for (int b = a + 1; b < points.size(); b++) {
        for (int c = b + 1; c < points.size(); c++) {
          if ((at.get(a) || at.get(b) || at.get(c)) && isEmpty(points, a, b, c)) {
            expected.add(name(a, b, c));
          }
        }
      }
    }
    return expected;
  }

  private static boolean isEmpty(Points points, int a, int b, int c) {
    int turn = points.orient(a, b, c);
    for (int d = 0; d < points.size(); d++) {
      boolean isInside =
          points.orient(a, b, d) * turn >= 0
              && points.orient(b, c, d) * turn >= 0
              && points.orient(c, a, d) * turn >= 0;
      if (d != a && d != b && d != c && isInside) {
        return false;
      }
    }
    return turn != 0;
  }

  @Test
  void givesUpAtTooMany() {
    Points square = Points.ofPairs(0, 0, 1, 0, 1, 1, 0, 1);
    BitSet one = new BitSet();
    one.set(0);
    assertThat(AllTriangles.of(square, 4, Progress.NONE)).isPresent();
    assertThat(AllTriangles.of(square, 3, Progress.NONE)).isEmpty();
    assertThat(AllTriangles.of(square, one, 3, Progress.NONE).orElseThrow().count()).isEqualTo(3);
    assertThat(AllTriangles.of(square, one, 2, Progress.NONE)).isEmpty();
  }
}
