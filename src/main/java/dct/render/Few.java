package dct.render;

import java.util.Arrays;

/** A few whole numbers among many, which are asked for by the run; immutable. */
final class Few {
  /** No number. */
  static final Few NONE = new Few(new int[0]);

  private final int[] sorted;

  private Few(int[] sorted) {
    this.sorted = sorted;
  }

  /** These numbers. */
  static Few of(int... numbers) {
    int[] sorted = numbers.clone();
    Arrays.sort(sorted);
    return new Few(sorted);
  }

  /** The numbers, in ascending order. */
  int[] toArray() {
    return sorted.clone();
  }

  /** Whether one of first … end − 1 is among them. */
  boolean meets(int first, int end) {
    if (sorted.length == 0) {
      return false;
    }
    int place = Arrays.binarySearch(sorted, first);
    int at = place < 0 ? -place - 1 : place;
    return at < sorted.length && sorted[at] < end;
  }

  /** Whether this is one of them. */
  boolean holds(int number) {
    return sorted.length > 0 && Arrays.binarySearch(sorted, number) >= 0;
  }
}
