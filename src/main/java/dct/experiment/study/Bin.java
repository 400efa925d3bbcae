package dct.experiment.study;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/**
 * One of the ranges, each a twentieth wide, into which shares are sorted.
 *
 * @param number 0 for the shares from 0 up to 0.05, and so on
 */
record Bin(int number) implements Comparable<Bin> {
  /** The polygons that are sorted have as many vertices: the shares of fewer lie too far apart. */
  static final int FEWEST_VERTICES = 100;

  private static final int BINS = 20; // for each 1

  /** The rows by the range of a share, without those of few vertices. */
  static Map<Bin, List<StudyRow>> sort(List<StudyRow> rows, ToDoubleFunction<StudyRow> share) {
    List<StudyRow> large = rows.stream().filter(row -> row.trial().n() >= FEWEST_VERTICES).toList();
    return Groups.by(large, row -> of(share.applyAsDouble(row)));
  }

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
