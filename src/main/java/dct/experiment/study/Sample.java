package dct.experiment.study;

import java.util.Arrays;
import java.util.Locale;

/**
 * What some measured values say of the mean behind them.
 *
 * @param size how many there are
 * @param mean their mean, NaN if there are none
 * @param deviation their standard deviation, with size − 1 in the denominator; 0 for one value
 */
public record Sample(int size, double mean, double deviation) {
  // Student's t, two-sided 95 %, for 1, 2, … degrees of freedom; beyond, a series is as good.
  private static final double[] T = {
    12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469, 2.3646, 2.3060, 2.2622, 2.2281, 2.2010, 2.1788
  };
  private static final double NORMAL = 1.959964; // the same quantile of the normal distribution

  /** The sample of these values. */
  public static Sample of(double... values) {
    double mean = Arrays.stream(values).sum() / values.length;
    double squares = Arrays.stream(values).map(v -> (v - mean) * (v - mean)).sum();
    double deviation = values.length < 2 ? 0 : Math.sqrt(squares / (values.length - 1));
    return new Sample(values.length, mean, deviation);
  }

  /**
   * Half the width of the 95 % interval of the mean, by Student's distribution; infinite for a
   * single value.
   */
  public double halfWidth() {
    return size < 2 ? Double.POSITIVE_INFINITY : quantile(size - 1) * deviation / Math.sqrt(size);
  }

  /** Student's quantile; from 13 degrees on by its expansion (Fisher 1926), to three digits. */
  private static double quantile(int degrees) {
    if (degrees <= T.length) {
      return T[degrees - 1];
    }
    double z = NORMAL;
    double cube = z * z * z;
    return z
        + (cube + z) / (4.0 * degrees)
        + (5 * cube * z * z + 16 * cube + 3 * z) / (96.0 * degrees * degrees);
  }

  /** Mean, half the 95 % interval and standard deviation: {@code 78.49 ± 0.43 (1.95)}. */
  String words() {
    if (size == 0) {
      return "–";
    }
    return size == 1
        ? String.format(Locale.ROOT, "%.2f", mean)
        : String.format(Locale.ROOT, "%.2f ± %.2f (%.2f)", mean, halfWidth(), deviation);
  }
}
