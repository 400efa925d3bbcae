package dct.experiment.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class SampleTest {

  @Test
  void mean_deviation_and_interval() {
    Sample sample = Sample.of(2, 4, 4, 4, 5, 5, 7, 9);
    assertThat(sample.mean()).isEqualTo(5);
    assertThat(sample.deviation()).isCloseTo(Math.sqrt(32.0 / 7), within(1e-12));
    assertThat(sample.halfWidth())
        .isCloseTo(2.3646 * sample.deviation() / Math.sqrt(8), within(1e-9));
    assertThat(sample.words()).isEqualTo("5.00 ± 1.79 (2.14)");
  }

  @Test
  void students_quantiles_are_those_of_the_tables() {
    requireQuantile(1, 12.7062);
    requireQuantile(4, 2.7764);
    requireQuantile(12, 2.1788);
    requireQuantile(13, 2.1604);
    requireQuantile(20, 2.0860);
    requireQuantile(60, 2.0003);
    requireQuantile(100_000, 1.9600);
  }

  private static void requireQuantile(int degrees, double quantile) {
    double halfWidth = new Sample(degrees + 1, 0, Math.sqrt(degrees + 1.0)).halfWidth();
    assertThat(halfWidth).as("%d degrees", degrees).isCloseTo(quantile, within(0.002));
  }

  @Test
  void one_value_has_no_interval_and_none_no_mean() {
    assertThat(Sample.of(3).words()).isEqualTo("3.00");
    assertThat(Sample.of(3).halfWidth()).isInfinite();
    assertThat(Sample.of().words()).isEqualTo("–");
  }
}
