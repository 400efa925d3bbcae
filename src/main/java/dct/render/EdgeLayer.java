package dct.render;

import java.util.Arrays;

/** Edges of one look; filled once, before it becomes part of a scene. */
final class EdgeLayer {
  private final Stroke stroke;
  private int[] ends; // two vertices an edge
  private int used;

  EdgeLayer(Stroke stroke, int expected) {
    this.stroke = stroke;
    this.ends = new int[2 * expected];
  }

  void add(int from, int to) {
    if (used == ends.length) {
      ends = Arrays.copyOf(ends, Math.max(8, 2 * used));
    }
    ends[used++] = from;
    ends[used++] = to;
  }

  Stroke stroke() {
    return stroke;
  }

  /** The number of edges. */
  int size() {
    return used / 2;
  }

  /** One end of edge k. */
  int from(int k) {
    return ends[2 * k];
  }

  /** The other end of edge k. */
  int to(int k) {
    return ends[2 * k + 1];
  }
}
