package dct.core.degree.region;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/** A growing list of vertices, or of half-edges, reused from round to round. */
public final class VertexList {
  private int[] items = new int[64];
  private int size;

  public int size() {
    return size;
  }

  public int get(int i) {
    return items[i];
  }

  void set(int i, int v) {
    items[i] = v;
  }

  public int last() {
    return items[size - 1];
  }

  public int removeLast() {
    return items[--size];
  }

  public void clear() {
    size = 0;
  }

  public void add(int v) {
    if (size == items.length) {
      items = Arrays.copyOf(items, 2 * size);
    }
    items[size++] = v;
  }

  /** The items in order. */
  public IntStream stream() {
    return Arrays.stream(items, 0, size);
  }

  void addAll(VertexList that) {
    for (int i = 0; i < that.size; i++) {
      add(that.items[i]);
    }
  }

  /** The vertices of that list which are to be kept, in order, each once; sorts that list. */
  void setSome(VertexList that, IntPredicate keeps) {
    Arrays.sort(that.items, 0, that.size);
    clear();
    for (int i = 0; i < that.size; i++) {
      int v = that.items[i];
      if (keeps.test(v) && (size == 0 || items[size - 1] != v)) {
        add(v);
      }
    }
  }
}
