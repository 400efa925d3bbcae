package dct.core.degree.search;

import java.util.Arrays;

/** A growing list of vertices, reused from round to round. */
final class VertexList {
  private int[] items = new int[64];
  private int size;

  int size() {
    return size;
  }

  int get(int i) {
    return items[i];
  }

  void clear() {
    size = 0;
  }

  void add(int v) {
    if (size == items.length) {
      items = Arrays.copyOf(items, 2 * size);
    }
    items[size++] = v;
  }

  void addAll(VertexList that) {
    for (int i = 0; i < that.size; i++) {
      add(that.items[i]);
    }
  }

  /** The vertices of that list which are unsatisfied, in order, each once; sorts that list. */
  void setUnsatisfied(VertexList that, SearchMesh mesh) {
    Arrays.sort(that.items, 0, that.size);
    clear();
    for (int i = 0; i < that.size; i++) {
      int v = that.items[i];
      if (mesh.isUnsatisfied(v) && (size == 0 || items[size - 1] != v)) {
        add(v);
      }
    }
  }
}
