package dct.core.degree.strip;

import dct.core.degree.region.SearchMesh;
import dct.core.degree.region.VertexList;

/**
 * Writes the triangles of a sweep into a {@link SearchMesh}, in place of those that a strip had: it
 * goes the moves again, and keeps for each edge of the path the half-edge below it. Linear time.
 */
final class StripFilling {
  private final SearchMesh mesh;
  private final VertexList slots; // where triangles go
  private final VertexList path = new VertexList(); // vertices that wait
  private final VertexList below = new VertexList(); // by edge between them: the half-edge below
  private final VertexList ahead = new VertexList(); // vertices, the nearest last
  private final VertexList belowAhead = new VertexList(); // the half-edge below the edge to each
  private int filled; // slots

  StripFilling(SearchMesh mesh, VertexList slots) {
    this.mesh = mesh;
    this.slots = slots;
  }

  /**
   * Fills the strip between two paths.
   *
   * @param vertex by rank
   */
  void fill(StripPath lower, StripPath upper, int[] vertex, int[] moves) {
    path.add(lower.vertex(0));
    for (int i = lower.size() - 1; i > 0; i--) {
      ahead.add(lower.vertex(i));
      belowAhead.add(lower.beyond(i - 1));
    }
    int closed = 0;
    for (int move : moves) {
      switch (move) {
        case SweepMove.CLOSE -> close(upper.beyond(closed++));
        case SweepMove.WAIT -> moveOn();
        case SweepMove.CUT -> cut();
        default -> join(vertex[move]);
      }
    }
  }

  private void close(int beyond) {
    if (belowAhead.last() != SearchMesh.NONE) {
      mesh.link(belowAhead.last(), beyond);
    }
    path.removeLast();
    path.add(ahead.removeLast());
    belowAhead.removeLast();
  }

  private void moveOn() {
    path.add(ahead.removeLast());
    below.add(belowAhead.removeLast());
  }

  private void cut() {
    int a = path.removeLast();
    int t = write(path.last(), a, ahead.last());
    mesh.link(t, below.removeLast());
    mesh.link(t + 1, belowAhead.removeLast());
    belowAhead.add(t + 2);
  }

  private void join(int c) {
    int t = write(path.last(), ahead.last(), c);
    mesh.link(t, belowAhead.removeLast());
    belowAhead.add(t + 1);
    ahead.add(c);
    belowAhead.add(t + 2);
  }

  private int write(int a, int b, int c) {
    int t = slots.get(filled++);
    setCorner(t, a);
    setCorner(t + 1, b);
    setCorner(t + 2, c);
    return t;
  }

  private void setCorner(int e, int v) {
    mesh.corner[e] = v;
    mesh.out[v] = e;
    mesh.wrong[v] ^= 1;
  }
}
