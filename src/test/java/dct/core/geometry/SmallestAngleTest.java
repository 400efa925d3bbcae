package dct.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class SmallestAngleTest {
  private static final double[] RIGHT = {0, 0, 4, 0, 0, 3};

  private static double cotangent(double[] t, int turn, double scale) {
    double[] s = new double[6];
    for (int i = 0; i < 6; i++) {
      s[i] = scale * t[(i + 2 * turn) % 6];
    }
    return SmallestAngle.cotangent(s[0], s[1], s[2], s[3], s[4], s[5]);
  }

  @Test
  void the_corner_named_first_and_the_scale_do_not_matter() {
    Random random = new Random(1);
    for (int k = 0; k < 1000; k++) {
      double[] t = random.doubles(6).toArray();
      if (Predicates.orient(t[0], t[1], t[2], t[3], t[4], t[5]) > 0) {
        double first = cotangent(t, 0, 1);
        assertThat(first).isGreaterThan(0.577);
        assertThat(cotangent(t, 1, 1)).isEqualTo(first);
        assertThat(cotangent(t, 2, 1)).isEqualTo(first);
        assertThat(cotangent(t, 0, 0x1p500)).isEqualTo(first);
      }
    }
    for (int power : new int[] {-1060, -500, -10, 0, 10, 500, 1020}) {
      assertThat(cotangent(RIGHT, 0, Math.scalb(1.0, power))).isCloseTo(4.0 / 3, within(1e-12));
    }
  }

  @Test
  void angles_are_in_degrees() {
    assertThat(SmallestAngle.degrees(cotangent(new double[] {0, 0, 1, 0, 0, 1}, 1, 1)))
        .isCloseTo(45, within(1e-12));
    assertThat(SmallestAngle.degrees(cotangent(new double[] {0, 0, 5, 0, 2.5, 1e-320}, 0, 1)))
        .isZero();
  }
}
