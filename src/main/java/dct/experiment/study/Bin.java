package dct.experiment.study;

import java.util.Locale;

/**
 * One of the ranges, each a twentieth wide, into which shares are sorted.
 *
 * @param number 0 for the shares from 0 up to 0.05, and so on
 */
record Bin(int number) implements Comparable<Bin> {
  private static final int BINS = 20; // for each 1

  /** The range of this share. */
  static Bin of(double share) {
    return new Bin((int) Math.floor(share * BINS));
  }

  /** The share in its middle. */
  double middle() {
    return (number + 0.5) / BINS;
  }

  /** Its ends. */
  String words() {
    return String.format(
        Locale.ROOT, "%.2f to %.2f", (double) number / BINS, (number + 1.0) / BINS);
  }

  @Override
  public int compareTo(Bin that) {
    return Integer.compare(number, that.number);
  }
}
