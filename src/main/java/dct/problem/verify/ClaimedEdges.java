package dct.problem.verify;

import dct.core.triangulate.EdgeKind;
import java.util.Arrays;

/**
 * A growing list of edges as they stand in a file, a column for each of their parts. An end may be
 * the number of a vertex that there is not.
 */
public final class ClaimedEdges {
  private int[] from = new int[16];
  private int[] to = new int[16];
  private int[] line = new int[16];
  private EdgeKind[] kind = new EdgeKind[16];
  private int size;

  /** Adds the edge that stands on this line. */
  public void add(int u, int v, EdgeKind edgeKind, int edgeLine) {
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

  /** The number of edges. */
  public int size() {
    return size;
  }

  /** The first end of edge i. */
  public int from(int i) {
    return from[i];
  }

  /** The other end of edge i. */
  public int to(int i) {
    return to[i];
  }

  /** What edge i is said to be. */
  public EdgeKind kind(int i) {
    return kind[i];
  }

  /** The line that edge i stands on, from 1 on. */
  public int line(int i) {
    return line[i];
  }

  int[] fromAll() {
    return Arrays.copyOf(from, size);
  }

  int[] toAll() {
    return Arrays.copyOf(to, size);
  }
}
