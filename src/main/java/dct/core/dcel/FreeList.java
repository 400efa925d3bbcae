package dct.core.dcel;

import java.util.Arrays;

/** Hands out the numbers 0, 1, 2, …; a number given back is handed out again first. */
final class FreeList {
  private int[] free = new int[0];
  private int freeCount;
  private int bound; // numbers below this one have been handed out

  FreeList() {}

  FreeList(FreeList that) {
    free = that.free.clone();
    freeCount = that.freeCount;
    bound = that.bound;
  }

  int take() {
    return freeCount > 0 ? free[--freeCount] : bound++;
  }

  void take(int count) {
    bound += count;
  }

  void give(int number) {
    if (freeCount == free.length) {
      free = Arrays.copyOf(free, Math.max(8, 2 * freeCount));
    }
    free[freeCount++] = number;
  }

  int bound() {
    return bound;
  }

  int size() {
    return bound - freeCount;
  }
}
