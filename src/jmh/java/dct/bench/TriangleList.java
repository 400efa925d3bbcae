package dct.bench;

import java.util.Arrays;

/** Vertex numbers of triangles, as they come. */
final class TriangleList {
  private int[] corners;
  private int size;

  /** Room for so many triangles at first. */
  TriangleList(int triangles) {
    corners = new int[3 * Math.max(1, triangles)];
  }

  void add(int a, int b, int c) {
    if (size == corners.length) {
      corners = Arrays.copyOf(corners, 2 * size);
    }
    corners[size++] = a;
    corners[size++] = b;
    corners[size++] = c;
  }

  int[] toArray() {
    return Arrays.copyOf(corners, size);
  }
}
