package dct.core.degree;

import dct.core.dcel.Dcel;
import java.util.Arrays;
import java.util.SplittableRandom;

/**
 * Triangles of a triangulated polygon that hang together by diagonals, and the simple polygon that
 * they cover. Used again for one region after the other.
 */
final class Region {
  private final int[] stamp; // by face: the number of the region that took it last
  private int current; // the number of this region
  private int[] inner = new int[64]; // half-edges of the diagonals inside
  private int innerCount;
  private int[] border = new int[64]; // half-edges that may be crossed next
  private int borderCount;

  /** For polygons of n vertices. */
  Region(int n) {
    stamp = new int[n + 2];
  }

  /**
   * Grows a region from a triangle at v, across diagonals chosen at random.
   *
   * @param size the number of vertices wanted; fewer if the polygon has fewer
   * @return the half-edges round it, counter-clockwise
   */
  int[] grow(Dcel dcel, int v, int size, SplittableRandom random) {
    current++;
    innerCount = 0;
    borderCount = 0;
    int start = dcel.outEdge(v);
    for (int turns = random.nextInt(dcel.degree(v)); turns > 0; turns--) {
      start = dcel.rotate(start);
    }
    start = dcel.face(start) == Dcel.OUTER ? start ^ 1 : start;
    take(dcel, start);
    offer(start);
    for (int vertices = 3; vertices < size && borderCount > 0; ) {
      int pick = random.nextInt(borderCount);
      int e = border[pick];
      border[pick] = border[--borderCount];
      if (dcel.face(e ^ 1) != Dcel.OUTER && !contains(dcel, e ^ 1)) {
        inner = with(inner, innerCount++, e);
        take(dcel, e ^ 1);
        vertices++;
      }
    }
    return outline(dcel, start);
  }

  private void take(Dcel dcel, int e) {
    stamp[dcel.face(e)] = current;
    offer(dcel.next(e));
    offer(dcel.prev(e));
  }

  private void offer(int e) {
    border = with(border, borderCount++, e);
  }

  private static int[] with(int[] list, int index, int value) {
    int[] roomy = index < list.length ? list : Arrays.copyOf(list, 2 * index);
    roomy[index] = value;
    return roomy;
  }

  private boolean contains(Dcel dcel, int e) {
    return stamp[dcel.face(e)] == current;
  }

  private int[] outline(Dcel dcel, int inside) {
    int first = outwards(dcel, inside);
    int[] corner = new int[innerCount + 3];
    int e = first;
    for (int k = 0; k < corner.length; k++) {
      corner[k] = e;
      e = outwards(dcel, dcel.next(e));
    }
    return corner;
  }

  /** The first half-edge of the outline that comes at or after e round the vertex that e leaves. */
  private int outwards(Dcel dcel, int e) {
    int out = e;
    while (contains(dcel, out ^ 1)) {
      out = dcel.next(out ^ 1);
    }
    return out;
  }

  /**
   * The number of edges outside the region at the vertex between two half-edges of its outline.
   *
   * @param out the one that leaves the vertex
   * @param in the one before it
   */
  int edgesOutside(Dcel dcel, int out, int in) {
    int inside = 2;
    for (int e = dcel.rotate(out); e != (in ^ 1); e = dcel.rotate(e)) {
      inside++;
    }
    return dcel.degree(dcel.origin(out)) - inside;
  }

  /** Removes the diagonals inside, so that the region is one face. */
  void clear(Dcel dcel) {
    for (int k = 0; k < innerCount; k++) {
      dcel.joinFaces(inner[k]);
    }
  }
}
