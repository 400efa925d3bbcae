package dct.io;

import dct.core.triangulate.EdgeKind;
import java.util.Arrays;

/** A growing list of edges, a column for each of their parts. */
final class EdgeColumns {
  private int[] from = new int[16];
  private int[] to = new int[16];
  private int[] line = new int[16];
  private EdgeKind[] kind = new EdgeKind[16];
  private int size;

  void add(int u, int v, EdgeKind edgeKind, int edgeLine) {
    if (size == from.length) {
      int longer = Math.multiplyExact(2, size);
      from = Arrays.copyOf(from, longer);
      to = Arrays.copyOf(to, longer);
      line = Arrays.copyOf(line, longer);
      kind = Arrays.copyOf(kind, longer);
    }
    from[size] = u;
    to[size] = v;
    line[size] = edgeLine;
    kind[size++] = edgeKind;
  }

  int size() {
    return size;
  }

  StoredResult.Edge get(int i) {
    return new StoredResult.Edge(from[i], to[i], kind[i], line[i]);
  }
}
