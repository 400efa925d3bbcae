package dct.core.triangulate;

import java.util.Arrays;

/** A list of half-edges that grows, and a stack of them. */
final class HalfEdgeList {
  private int[] list = new int[32];
  private int size;

  void add(int e) {
    if (size == list.length) {
      list = Arrays.copyOf(list, 2 * size);
    }
    list[size++] = e;
  }

  /** Takes the half-edge out that was added last. */
  int pop() {
    return list[--size];
  }

  int get(int k) {
    return list[k];
  }

  int size() {
    return size;
  }

  int[] toArray() {
    return Arrays.copyOf(list, size);
  }
}
