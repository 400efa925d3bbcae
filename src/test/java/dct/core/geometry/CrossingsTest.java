package dct.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Where edges cross.
 *
 * <pre>
 * Points bowTie = Points.ofPairs(0, 0, 10, 10, 10, 0, 0, 10);
 * Defect crossing = Crossings.of(Rings.ofChain(bowTie), Progress.NONE).get(0);
 * crossing.first();  // 0, the edge v0–v1
 * crossing.second(); // 2, the edge v2–v3
 * crossing.x();      // 5.0
 * </pre>
 */
class CrossingsTest {

  @Test
  void allCrossingsAreFoundNotOnlyTheFirst() {
    // A line through three teeth.
    Points points =
        Points.ofPairs(0, 5, 70, 5, 70, 20, 60, 0, 50, 20, 40, 0, 30, 20, 20, 0, 10, 20);
    assertThat(Crossings.of(Rings.ofChain(points), Progress.NONE))
        .hasSize(6)
        .allSatisfy(crossing -> assertThat(crossing.first()).isZero())
        .allSatisfy(crossing -> assertThat(crossing.y()).isEqualTo(5));
  }

  @Test
  void theCrossingOfABowTieIsInItsMiddle() {
    assertThat(
            Crossings.of(Rings.ofChain(Points.ofPairs(0, 0, 10, 10, 10, 0, 0, 10)), Progress.NONE))
        .containsExactly(new Defect(Defect.Kind.CROSSING, 0, 2, 5, 5, 4));
  }

  @Test
  void aPolygonIsFoundToCrossIfTheCheckSaysSo() {
    for (long seed = 0; seed < 300; seed++) {
      Random random = new Random(seed);
      double[] pairs = random.doubles(2L * (3 + random.nextInt(6)), 0, 100).toArray();
      Points points = Points.ofPairs(pairs);
      assertThat(Crossings.of(Rings.ofChain(points), Progress.NONE).isEmpty())
          .as("seed %d", seed)
          .isEqualTo(SimplicityCheck.firstDefect(points, Progress.NONE).isEmpty());
    }
  }

  /** The coordinate differences and their products overflow or vanish at most of these scales. */
  @Test
  void aBowTieOfEveryScaleCrossesInItsMiddle() {
    for (int exponent = Double.MIN_EXPONENT - 52; exponent < Double.MAX_EXPONENT; exponent++) {
      double s = Math.scalb(1.0, exponent);
      checkBowTie(Points.ofPairs(0, 0, 2 * s, 2 * s, 2 * s, 0, 0, 2 * s), s, s);
      checkBowTie(Points.ofPairs(-s, -s, s, s, s, -s, -s, s), 0, 0);
      checkBowTie(Points.ofPairs(0, 0, 2 * s, 2, 2 * s, 0, 0, 2), s, 1);
    }
    double most = Double.MAX_VALUE;
    checkBowTie(Points.ofPairs(-most, -most, most, most, most, -most, -most, most), 0, 0);
  }

  private static void checkBowTie(Points bowTie, double x, double y) {
    Defect expected = new Defect(Defect.Kind.CROSSING, 0, 2, x, y, 4);
    assertThat(Crossings.of(Rings.ofChain(bowTie), Progress.NONE)).containsExactly(expected);
    assertThat(SimplicityCheck.firstDefect(bowTie, Progress.NONE)).contains(expected);
  }

  /** Edges that part by single ulps: where they cross is still one of the doubles next to it. */
  @Test
  void theCrossingIsRoundedOnceAtEveryScaleAndNextToVertices() {
    for (int seed = 0; seed < 2000; seed++) {
      Random random = new Random(seed);
      double scale = Math.scalb(1.0, random.nextInt(2040) - 1040);
      double[] c = random.doubles(8, -1, 1).map(t -> t * scale).toArray();
      if (seed % 2 == 0) { // all four near one point
        for (int i = 2; i < 8; i++) {
          c[i] = c[i % 2] + (random.nextInt(9) - 4) * Math.ulp(c[i % 2]);
        }
      }
      Points p =
          Points.of(new double[] {c[0], c[2], c[4], c[6]}, new double[] {c[1], c[3], c[5], c[7]});
      for (Defect d : Crossings.of(Rings.ofChain(p), Progress.NONE)) {
        int a = d.first();
        int b = d.second();
        assertNearest(d.x(), coordinate(p.xs(), p, a, b), seed);
        assertNearest(d.y(), coordinate(p.ys(), p, a, b), seed);
      }
    }
  }

  /** Half an ulp away at most; with a tie it may be either of two. */
  private static void assertNearest(double rounded, BigDecimal exact, int seed) {
    BigDecimal error = big(rounded).subtract(exact).abs();
    BigDecimal half =
        big(Math.ulp(rounded)).multiply(new BigDecimal("0.50000000000000000000000001"));
    assertThat(error).as("seed %d", seed).isLessThanOrEqualTo(half);
  }

  /** By Cramer's rule on the equations of both lines. */
  private static BigDecimal coordinate(double[] of, Points p, int a, int c) {
    int b = (a + 1) % p.size();
    int d = (c + 1) % p.size();
    BigDecimal ab = det(p.xs(), p.ys(), a, b);
    BigDecimal cd = det(p.xs(), p.ys(), c, d);
    BigDecimal top = ab.multiply(minus(of, c, d)).subtract(minus(of, a, b).multiply(cd));
    BigDecimal bottom =
        minus(p.xs(), a, b)
            .multiply(minus(p.ys(), c, d))
            .subtract(minus(p.ys(), a, b).multiply(minus(p.xs(), c, d)));
    return top.divide(bottom, new MathContext(400));
  }

  private static BigDecimal det(double[] x, double[] y, int a, int b) {
    return big(x[a]).multiply(big(y[b])).subtract(big(y[a]).multiply(big(x[b])));
  }

  private static BigDecimal minus(double[] values, int a, int b) {
    return big(values[a]).subtract(big(values[b]));
  }

  private static BigDecimal big(double value) {
    return new BigDecimal(value);
  }

  @Test
  void aLevelLineMeetsASegmentAtTheNextDoubleOnEitherSide() {
    Points third = Points.ofPairs(0, 0, 1, 3);
    assertThat(Crossings.levelX(third, 0, 1, 1, true)).isEqualTo(1 / 3.0);
    assertThat(Crossings.levelX(third, 1, 0, 1, false)).isEqualTo(Math.nextUp(1 / 3.0));
    assertThat(Crossings.levelX(third, 0, 1, 3, true)).isEqualTo(1);
    assertThat(Crossings.levelX(third, 0, 1, 3, false)).isEqualTo(1);
    double most = Double.MAX_VALUE;
    Points all = Points.ofPairs(-most, -most, most, most);
    assertThat(Crossings.levelX(all, 0, 1, 1e-300, true)).isEqualTo(1e-300);
  }
}
