package dct.core.degree.region;

import dct.core.SeededRandom;
import dct.core.dcel.Dcel;
import java.util.Arrays;

/**
 * Triangles of a triangulation that hang together by inner edges so that they cover a simple
 * polygon with no vertex inside. Used again for one region after the other.
 */
final class Region {
  private final int[] stamp; // by face: the number of the region that took it last
  private final int[] vertexStamp; // by vertex: the same
  private int current; // the number of this region
  private int[] inner = new int[64]; // half-edges of the diagonals inside
  private int innerCount;
  private int[] border = new int[64]; // half-edges that may be crossed next
  private int borderCount;

  /** For regions of this triangulation, also while its inner edges change. */
  Region(Dcel dcel) {
    stamp = new int[dcel.faceBound()];
    vertexStamp = new int[dcel.vertexCount()];
  }

  /**
   * Grows a region from a triangle at v, across edges chosen at random. A triangle whose far corner
   * is in the region already is left out: it would enclose a vertex or touch the region from
   * outside.
   *
   * @param size the number of vertices wanted; there are fewer where no triangle can be added
   * @return the half-edges round it, counter-clockwise
   */
  int[] grow(Dcel dcel, int v, int size, SeededRandom random) {
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
    vertexStamp[dcel.origin(start)] = current;
    vertexStamp[dcel.target(start)] = current;
    for (int vertices = 3; vertices < size && borderCount > 0; ) {
      int pick = random.nextInt(borderCount);
      int e = border[pick];
      border[pick] = border[--borderCount];
      if (canCross(dcel, e)) {
        inner = with(inner, innerCount++, e);
        take(dcel, e ^ 1);
        vertices++;
      }
    }
    return outline(dcel, start);
  }

  private boolean canCross(Dcel dcel, int e) {
    return dcel.face(e ^ 1) != Dcel.OUTER && vertexStamp[dcel.origin(dcel.prev(e ^ 1))] != current;
  }

  /** Adds the triangle of e, whose ends are in the region already. */
  private void take(Dcel dcel, int e) {
    stamp[dcel.face(e)] = current;
    vertexStamp[dcel.origin(dcel.prev(e))] = current;
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
