package dct.core.degree.region;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ExactGridTest {

  private static boolean holds(double... values) {
    return ExactGrid.holds(values, new double[] {0});
  }

  @Test
  void holds_for_whole_numbers_close_enough() {
    assertThat(holds(0, 1, 2, 1 << 26)).isTrue();
    assertThat(holds(-1, 0, (1 << 26) - 1)).isTrue();
    assertThat(holds(0, 1, 2, (1 << 26) + 1)).isFalse();
    assertThat(holds(0, 3, 3 * 0x1p30)).isFalse();
  }

  @Test
  void the_unit_is_the_lowest_bit_of_all() {
    assertThat(holds(0.5, 0.25, 1000)).isTrue();
    assertThat(holds(0.1, 0.2)).isFalse();
    assertThat(holds(3 * 0x1p40, 5 * 0x1p40, 0)).isTrue();
    assertThat(holds(1 + 0x1p-52, 1, 0)).isFalse();
  }

  @Test
  void a_range_far_from_the_origin_counts_by_its_extent() {
    double[] x = {0x1p40, 0x1p40 + 1};
    double[] y = {0x1p40, 0x1p40 + 3};
    assertThat(ExactGrid.holds(x, y)).isTrue();
  }

  @Test
  void extreme_exponents_are_refused() {
    assertThat(holds(Double.MIN_VALUE, 2 * Double.MIN_VALUE)).isFalse();
    assertThat(holds(0x1p1000, 0x1p1001)).isFalse();
  }
}
