package dct.core.degree.bound;

import java.util.Arrays;

/**
 * Unknowns that are 0 or 1, under rows that say: the sum of some of them less the sum of others is
 * a given number. Tries to show that nothing fulfils all rows.
 *
 * <p>The least and the greatest value that a row can still take are kept. Where one of them is the
 * given number all free unknowns of the row follow; where that number is out of reach the rows are
 * refuted. Where nothing follows, the free unknowns of one row are tried one after the other, a few
 * times at most.
 */
final class ColourRows {
  private static final int NONE = -1;
  private static final byte FREE = -1;

  // Row r has the places start[r] … start[r + 1] − 1: first those added, then those subtracted.
  private int[] start = new int[64];
  private int[] middle = new int[64]; // by row: the first place that is subtracted
  private int[] wanted = new int[64]; // by row
  private int[] unknown = new int[256]; // by place
  private int rows;

  private int[] least; // by row
  private int[] greatest; // by row
  private int[] firstUse; // by unknown: where its uses begin
  private int[] use; // twice the row, plus 1 where it is subtracted
  private byte[] value; // by unknown
  private int[] trail; // unknowns in the order in which they were given a value
  private int trailSize;
  private int[] queue; // rows to look at
  private int queueSize;
  private boolean[] isQueued; // by row
  private int branchings;
  private long steps;

  /** Begins a row whose sum shall be this number. */
  void begin(int number) {
    if (rows + 1 == start.length) {
      start = Arrays.copyOf(start, 2 * rows + 2);
      middle = Arrays.copyOf(middle, start.length);
      wanted = Arrays.copyOf(wanted, start.length);
    }
    wanted[rows] = number;
    start[rows + 1] = start[rows];
    middle[rows] = start[rows];
    rows++;
  }

  /** Adds an unknown to the row begun last; none may have been subtracted yet. */
  void plus(int x) {
    put(x);
    middle[rows - 1]++;
  }

  /** Subtracts an unknown in the row begun last. */
  void minus(int x) {
    put(x);
  }

  private void put(int x) {
    int place = start[rows]++;
    if (place == unknown.length) {
      unknown = Arrays.copyOf(unknown, 2 * place);
    }
    unknown[place] = x;
  }

  /** How many uses of unknowns were looked at. */
  long steps() {
    return steps;
  }

  /**
   * Whether it was shown that nothing fulfils the rows.
   *
   * @param unknowns their number
   * @param zeros some that are known to be 0
   * @param mostBranchings give up after so many
   */
  boolean isRefuted(int unknowns, int[] zeros, int mostBranchings) {
    branchings = mostBranchings;
    index(unknowns);
    for (int x : zeros) {
      fix(x, 0);
    }
    return isRefuted();
  }

  private void index(int unknowns) {
    least = new int[rows];
    greatest = new int[rows];
    value = new byte[unknowns];
    Arrays.fill(value, FREE);
    trail = new int[unknowns];
    queue = new int[rows];
    isQueued = new boolean[rows];
    firstUse = new int[unknowns + 1];
    for (int place = 0; place < start[rows]; place++) {
      firstUse[unknown[place] + 1]++;
    }
    Arrays.parallelPrefix(firstUse, Integer::sum);
    int[] free = Arrays.copyOf(firstUse, unknowns);
    use = new int[start[rows]];
    for (int r = 0; r < rows; r++) {
      least[r] = middle[r] - start[r + 1];
      greatest[r] = middle[r] - start[r];
      for (int place = start[r]; place < start[r + 1]; place++) {
        use[free[unknown[place]]++] = 2 * r + (place < middle[r] ? 0 : 1);
      }
      enqueue(r);
    }
    steps += start[rows];
  }

  private void enqueue(int r) {
    if (!isQueued[r]) {
      isQueued[r] = true;
      queue[queueSize++] = r;
    }
  }

  /** Gives an unknown a value; false if it has the other one. */
  private boolean fix(int x, int to) {
    if (value[x] != FREE) {
      return value[x] == to;
    }
    value[x] = (byte) to;
    trail[trailSize++] = x;
    for (int i = firstUse[x]; i < firstUse[x + 1]; i++) {
      int r = use[i] >> 1;
      boolean raises = (use[i] & 1) != to; // added and 1, or subtracted and 0
      least[r] += raises ? 1 : 0;
      greatest[r] -= raises ? 0 : 1;
      enqueue(r);
    }
    steps += firstUse[x + 1] - firstUse[x];
    return true;
  }

  private void undoTo(int size) {
    while (trailSize > size) {
      int x = trail[--trailSize];
      for (int i = firstUse[x]; i < firstUse[x + 1]; i++) {
        boolean raised = (use[i] & 1) != value[x];
        least[use[i] >> 1] -= raised ? 1 : 0;
        greatest[use[i] >> 1] += raised ? 0 : 1;
      }
      value[x] = FREE;
    }
    clearQueue();
  }

  private void clearQueue() {
    while (queueSize > 0) {
      isQueued[queue[--queueSize]] = false;
    }
  }

  /** Draws all conclusions; false if a row cannot have its number. */
  private boolean propagate() {
    while (queueSize > 0) {
      int r = queue[--queueSize];
      isQueued[r] = false;
      if (least[r] > wanted[r] || greatest[r] < wanted[r]) {
        clearQueue();
        return false;
      }
      boolean isLow = least[r] == wanted[r];
      if (least[r] < greatest[r] && (isLow || greatest[r] == wanted[r])) {
        settle(r, isLow);
      }
    }
    return true;
  }

  /** The row has its least value, or its greatest. */
  private void settle(int r, boolean isLow) {
    for (int place = start[r]; place < start[r + 1]; place++) {
      if (value[unknown[place]] == FREE) {
        fix(unknown[place], place < middle[r] == isLow ? 0 : 1);
      }
    }
  }

  private boolean isRefuted() {
    if (!propagate()) {
      return true;
    }
    int row = branchings-- > 0 ? rowToBranchOn() : NONE;
    if (row == NONE) {
      return false;
    }
    for (int place = start[row]; place < start[row + 1]; place++) {
      int x = unknown[place];
      if (value[x] == FREE) {
        int mark = trailSize;
        fix(x, 1);
        if (!isRefuted()) {
          return false;
        }
        undoTo(mark);
        fix(x, 0);
        if (!propagate()) {
          return true;
        }
      }
    }
    return isRefuted();
  }

  /** The row with the fewest free unknowns, of those that lack a 1; or NONE. */
  private int rowToBranchOn() {
    int best = NONE;
    for (int r = 0; r < rows; r++) {
      boolean isShorter = best == NONE || greatest[r] - least[r] < greatest[best] - least[best];
      if (greatest[r] > least[r] && isShorter && (wanted[r] == 1 || hasOne(r))) {
        best = r;
      }
    }
    return best;
  }

  private boolean hasOne(int r) {
    for (int place = start[r]; place < start[r + 1]; place++) {
      if (value[unknown[place]] == 1) {
        return true;
      }
    }
    return false;
  }
}
