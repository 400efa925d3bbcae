package dct.core.degree.strip;

import dct.core.degree.region.SearchMesh;
import dct.core.degree.region.VertexList;
import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * A path along edges of a {@link SearchMesh} on which each vertex comes after the one before it in
 * a {@link StripOrder}, and the way it moves over the triangles on one side of it.
 */
final class StripPath {
  private final SearchMesh mesh;
  private final boolean down; // it moves downwards, the order going to the right
  private int[] vertex = new int[64];
  private int[] beyond =
      new int[64]; // by place: the half-edge on its far side of the edge from here
  private int size; // vertices

  StripPath(SearchMesh mesh, boolean down) {
    this.mesh = mesh;
    this.down = down;
  }

  /** The number of vertices. */
  int size() {
    return size;
  }

  /** The vertex at a place. */
  int vertex(int place) {
    return vertex[place];
  }

  /** The half-edge on the far side of the edge from this place to the next, or NONE. */
  int beyond(int place) {
    return beyond[place];
  }

  /** The vertices in order. */
  IntStream vertices() {
    return Arrays.stream(vertex, 0, size);
  }

  /** Begins anew at v. */
  void begin(int v) {
    vertex[0] = v;
    size = 1;
  }

  /** Goes on to v, along an edge with this half-edge on the far side. */
  void add(int far, int v) {
    if (size == vertex.length) {
      vertex = Arrays.copyOf(vertex, 2 * size);
      beyond = Arrays.copyOf(beyond, 2 * size);
    }
    beyond[size - 1] = far;
    vertex[size++] = v;
  }

  /**
   * Moves over one layer of triangles: those whose apex comes between the ends of an edge of the
   * path, and those that are then, or were, on two edges.
   *
   * <pre>
   *     a ───────── b          a ──→ b
   *       ↘       ↗      or      ↘   ↓
   *           c                      c
   * </pre>
   *
   * @param passed receives the first half-edge of each triangle
   */
  void advance(StripOrder order, VertexList passed) {
    int n = size;
    int[] oldVertex = Arrays.copyOf(vertex, n);
    int[] oldBeyond = Arrays.copyOf(beyond, n);
    size = 1;
    for (int i = 0; i + 1 < n; i++) {
      int far = oldBeyond[i];
      int apex = far == SearchMesh.NONE ? far : mesh.corner[SearchMesh.prev(far)];
      boolean isBetween =
          apex != SearchMesh.NONE
              && order.isBefore(oldVertex[i], apex)
              && order.isBefore(apex, oldVertex[i + 1]);
      if (isBetween) {
        passed.add(far & ~3);
        int next = mesh.twin[SearchMesh.next(far)];
        int prev = mesh.twin[SearchMesh.prev(far)];
        goOn(down ? next : prev, apex, passed);
        goOn(down ? prev : next, oldVertex[i + 1], passed);
      } else {
        goOn(far, oldVertex[i + 1], passed);
      }
    }
  }

  /** Adds an edge, and as long as it and the one before it are on one triangle, passes that. */
  private void goOn(int far, int v, VertexList passed) {
    int last = far;
    while (last != SearchMesh.NONE && size > 1 && beyond[size - 2] >> 2 == last >> 2) {
      passed.add(last & ~3);
      boolean isNext = SearchMesh.next(last) == beyond[size - 2];
      last = mesh.twin[isNext ? SearchMesh.prev(last) : SearchMesh.next(last)];
      size--;
    }
    add(last, v);
  }
}
