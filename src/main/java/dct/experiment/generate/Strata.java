package dct.experiment.generate;

import dct.core.SeededRandom;
import java.util.Locale;

/** Increasing random numbers that are spread evenly. */
final class Strata {
  private Strata() {}

  /** Increasing numbers from 0 to size − 1: a random one from each of {@code count} equal parts. */
  static int[] increasing(int count, long size, SeededRandom random) {
    int[] values = new int[count];
    for (int i = 0; i < count; i++) {
      long low = size * i / count;
      long high = size * (i + 1) / count;
      values[i] = (int) (low + random.nextLong(high - low));
    }
    return values;
  }

  /**
   * Makes sure that there are as many numbers as parts.
   *
   * @param what what needs them
   * @throws CannotGenerateException if there are not
   */
  static void check(int count, long size, String what) {
    if (count > size) {
      throw new CannotGenerateException(
          String.format(
              Locale.ROOT,
              "%s needs %d places a side where the area has %d; take a larger area or fewer",
              what,
              count,
              size));
    }
  }
}
