package dct.problem.verify;

import dct.core.degree.Flip;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A growing list of flips in order as they stand in a file. A corner may be the number of a vertex
 * that there is not.
 */
public final class ClaimedFlips {
  private final List<Flip> flips = new ArrayList<>();
  private int[] line = new int[16];

  /** Adds the flip that stands on this line. */
  public void add(Flip flip, int flipLine) {
    if (flips.size() == line.length) {
      line = Arrays.copyOf(line, Math.multiplyExact(2, line.length));
    }
    line[flips.size()] = flipLine;
    flips.add(flip);
  }

  /** The number of flips. */
  public int size() {
    return flips.size();
  }

  /** Flip i, from 0 on. */
  public Flip flip(int i) {
    return flips.get(i);
  }

  /** The line that flip i stands on, from 1 on. */
  public int line(int i) {
    return line[i];
  }
}
