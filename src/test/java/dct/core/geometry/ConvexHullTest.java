package dct.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Whether points are alone in their hull, against every triangle and segment between them. */
class ConvexHullTest {

  @Test
  void isAloneUnlessATriangleOrASegmentContainsAnother() {
    int alone = 0;
    for (long seed = 0; seed < 400; seed++) {
      Random random = new Random(seed);
      Points points = lattice(random, 3 + random.nextInt(8));
      BitSet some = new BitSet();
      some.set(random.nextInt(points.size()));
      for (int v = 0; v < points.size(); v++) {
        some.set(v, some.get(v) || random.nextInt(3) == 0);
      }
      boolean expected = true;
      for (int v = 0; v < points.size(); v++) {
        expected &= some.get(v) || !isCovered(points, some.stream().toArray(), v);
      }
      assertThat(ConvexHull.isAlone(points, some))
          .as("seed %d, %s", seed, some)
          .isEqualTo(expected);
      alone += expected ? 1 : 0;
    }
    assertThat(alone).isBetween(50, 350);
  }

  /** Different points of a small lattice, many of them on a line. */
  private static Points lattice(Random random, int n) {
    BitSet cells = new BitSet();
    while (cells.cardinality() < n) {
      cells.set(random.nextInt(20));
    }
    double[] x = cells.stream().mapToDouble(cell -> cell % 5).toArray();
    double[] y = cells.stream().mapToDouble(cell -> Math.floorDiv(cell, 5)).toArray();
    return Points.of(x, y);
  }

  private static boolean isCovered(Points points, int[] some, int v) {
    for (int a : some) {
      for (int b : some) {
        for (int c : some) {
          boolean isFlat = points.orient(a, b, c) == 0;
          if (isFlat ? isOnSegment(points, a, b, v) : isInside(points, a, b, c, v)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  private static boolean isOnSegment(Points points, int a, int b, int v) {
    double dot =
        (points.x(a) - points.x(v)) * (points.x(b) - points.x(v))
            + (points.y(a) - points.y(v)) * (points.y(b) - points.y(v));
    return points.orient(a, b, v) == 0 && dot <= 0;
  }

  private static boolean isInside(Points points, int a, int b, int c, int v) {
    int turn = points.orient(a, b, c);
    return points.orient(a, b, v) * turn >= 0
        && points.orient(b, c, v) * turn >= 0
        && points.orient(c, a, v) * turn >= 0;
  }
}
