package dct.core.geometry;

import dct.core.Progress;

/**
 * The points that equal no earlier one, in a hash table of their numbers with linear probing: on a
 * million points several times as fast as sorting them.
 */
final class FirstOccurrences {
  private static final long MIX_X = 0x9E3779B97F4A7C15L; // odd, with bits well spread
  private static final long MIX_Y = 0xC2B2AE3D27D4EB4FL;

  private final Points points;
  private final int[] table; // by hash: the number of a point plus 1, or 0; at most half full
  private final int shift; // of a hash, to the length of the table

  FirstOccurrences(Points points) {
    this.points = points;
    int bits = 33 - Integer.numberOfLeadingZeros(points.size() | 1);
    table = new int[1 << bits];
    shift = Long.SIZE - bits;
  }

  /** Marks the points that equal an earlier one; returns their number. */
  int markOthers(boolean[] duplicate, Progress progress) {
    int count = 0;
    for (int i = 0; i < duplicate.length; i++) {
      Progress.tick(progress, i, duplicate.length, "Merging equal sites");
      int place = hash(points.x(i), points.y(i));
      while (table[place] != 0 && !points.same(table[place] - 1, i)) {
        place = (place + 1) & (table.length - 1);
      }
      if (table[place] == 0) {
        table[place] = i + 1;
      } else {
        duplicate[i] = true;
        count++;
      }
    }
    return count;
  }

  private int hash(double x, double y) {
    // Adding 0 makes one number of the two zeros, which are the same coordinate.
    long hx = Double.doubleToRawLongBits(x + 0.0) * MIX_X;
    long hy = Double.doubleToRawLongBits(y + 0.0) * MIX_Y;
    long h = (hx ^ (hx >>> 29)) + Long.rotateLeft(hy, 31);
    return (int) ((h * MIX_X) >>> shift);
  }
}
