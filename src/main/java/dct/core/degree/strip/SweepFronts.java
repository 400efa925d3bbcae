package dct.core.degree.strip;

/**
 * States of a sweep over a {@link Strip}, each a path between the part that is triangulated, below,
 * and the rest: kept as two stacks that meet where the next triangle may be added.
 *
 * <p>Of the path it holds what can still change. The vertices that wait are those from the last one
 * finished on the upper path to the one where the next edge begins; those ahead follow, the nearest
 * last; then come those of the lower path that were never reached. A vertex is kept as twice its
 * rank, plus 1 if it has not the parity wished with the triangles so far.
 */
final class SweepFronts {
  private static final int ROOM = 128; // vertices of a stack; paths that need more are given up

  private final Strip strip;
  private final int[] waiting; // by state and place
  private final int[] ahead; // by state and place
  private final int[] waitingSize; // by state
  private final int[] aheadSize; // by state
  private final int[] nextLower; // by state: the place of the first one never reached
  final int[] unmet; // by state: how many vertices are finished and unmet
  final int[] met; // by state: how many are finished and not unmet
  final long[] key; // by state: the same for two states if they can be continued in the same ways
  int size; // states

  SweepFronts(Strip strip, int width) {
    this.strip = strip;
    waiting = new int[width * ROOM];
    ahead = new int[width * ROOM];
    waitingSize = new int[width];
    aheadSize = new int[width];
    nextLower = new int[width];
    unmet = new int[width];
    met = new int[width];
    key = new long[width];
  }

  /** Begins with one state: the lower path. */
  void begin() {
    size = 1;
    waiting[0] = outside(strip.lower(0));
    waitingSize[0] = 1;
    nextLower[0] = 1;
  }

  private int outside(int rank) {
    return rank << 1 | strip.wrongOutside(rank);
  }

  /** Whether the next edge of a state has an end; if not the state is the upper path. */
  boolean hasNext(int s) {
    if (aheadSize[s] == 0 && nextLower[s] < strip.lowerSize()) {
      ahead[s * ROOM] = outside(strip.lower(nextLower[s]++));
      aheadSize[s] = 1;
    }
    return aheadSize[s] > 0;
  }

  /** The vertex where the next edge begins. */
  int here(int s) {
    return waiting[s * ROOM + waitingSize[s] - 1];
  }

  /** The vertex where the next edge ends. */
  int next(int s) {
    return ahead[s * ROOM + aheadSize[s] - 1];
  }

  /** Whether an edge waits for the next one. */
  boolean hasWaiting(int s) {
    return waitingSize[s] > 1;
  }

  /** The vertex where the edge that waits for the next one begins. */
  int waiting(int s) {
    return waiting[s * ROOM + waitingSize[s] - 2];
  }

  /** Whether there is room for another vertex. */
  boolean hasRoom(int s) {
    return waitingSize[s] < ROOM && aheadSize[s] < ROOM;
  }

  /** Adds the state which that one becomes by a move; its counts and key are to be set. */
  void add(SweepFronts from, int s, int move) {
    int q = size++;
    waitingSize[q] = from.waitingSize[s];
    aheadSize[q] = from.aheadSize[s];
    nextLower[q] = from.nextLower[s];
    System.arraycopy(from.waiting, s * ROOM, waiting, q * ROOM, waitingSize[q]);
    System.arraycopy(from.ahead, s * ROOM, ahead, q * ROOM, aheadSize[q]);
    move(q, move);
  }

  private void move(int q, int move) {
    int top = q * ROOM + waitingSize[q] - 1;
    int front = q * ROOM + aheadSize[q] - 1;
    switch (move) {
      case SweepMove.CLOSE -> {
        waiting[top] = ahead[front];
        aheadSize[q]--;
      }
      case SweepMove.WAIT -> {
        waiting[top + 1] = ahead[front];
        waitingSize[q]++;
        aheadSize[q]--;
      }
      case SweepMove.CUT -> {
        waiting[top - 1] ^= 1;
        ahead[front] ^= 1;
        waitingSize[q]--;
      }
      default -> {
        waiting[top] ^= 1;
        ahead[front] ^= 1;
        ahead[front + 1] = outside(move) ^ 1;
        aheadSize[q]++;
      }
    }
  }
}
