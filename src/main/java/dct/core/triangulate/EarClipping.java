package dct.core.triangulate;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;

/**
 * Triangulates a simple polygon by cutting off ears (Meisters 1975; thesis, Algorithm 2.1).
 *
 * <p>Takes any simple polygon. A vertex b between a and c is an ear if abc turns strictly left and
 * no vertex of the rest whose angle is 180° or more lies in the closed triangle; so no triangle is
 * flat and no diagonal touches a vertex.
 *
 * <p>Candidates wait in a queue, at first all vertices in their counter-clockwise order; cutting an
 * ear puts its two neighbours at the end. That is enough: the polygon only shrinks, so a vertex
 * that is no ear can become one only when a neighbour of it goes. There are fewer than 3n tests,
 * each of which looks at the reflex vertices in the cells of a grid that the triangle's box covers:
 * O(n²) time at worst, close to O(n log n) on most polygons. O(n) space, exact.
 */
public final class EarClipping {
  private static final int LOOKS_BETWEEN_REPORTS = 1 << 14; // tests and what they look at

  private final SimplePolygon polygon;
  private final Points points;
  private final Dcel dcel;
  private final int[] corner; // by vertex: the half-edge that leaves it in the rest of the polygon
  private final boolean[] waiting; // by vertex: is in the queue
  private final VertexQueue queue;
  private final ReflexGrid reflex;
  private int left; // the number of vertices of the rest

  private EarClipping(SimplePolygon polygon, Progress progress) {
    this.polygon = polygon;
    points = polygon.points();
    left = polygon.size();
    dcel = Dcel.cycle(polygon.walk());
    corner = new int[left];
    waiting = new boolean[left];
    queue = new VertexQueue(left);
    boolean[] isReflex = new boolean[left];
    for (int k = 0; k < left; k++) {
      Progress.check(progress, k);
      int v = polygon.vertex(k);
      corner[v] = 2 * k;
      isReflex[v] = !isConvex(v);
    }
    reflex = new ReflexGrid(points, isReflex);
  }

  /**
   * A triangulation of a simple polygon.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Triangulation triangulate(SimplePolygon polygon, Progress progress) {
    EarClipping run = new EarClipping(polygon, progress);
    run.clipAll(progress);
    return new Triangulation(Domain.POLYGON, run.points, run.dcel, edge -> EdgeKind.DIAGONAL);
  }

  private void clipAll(Progress progress) {
    int n = left;
    for (int k = 0; k < n; k++) {
      enqueue(polygon.vertex(k));
    }
    long due = 0;
    for (long tests = 0; left > 3; tests++) {
      if (tests + reflex.looks() >= due) {
        due = tests + reflex.looks() + LOOKS_BETWEEN_REPORTS;
        progress.checkCancelled();
        progress.report(1 - (double) left / n, "Clipping ears");
      }
      int b = queue.remove();
      waiting[b] = false;
      if (isEar(b)) {
        clip(b);
      }
    }
  }

  private void enqueue(int v) {
    if (!waiting[v]) {
      waiting[v] = true;
      queue.add(v);
    }
  }

  private int before(int v) {
    return dcel.origin(dcel.prev(corner[v]));
  }

  private int after(int v) {
    return dcel.target(corner[v]);
  }

  private boolean isConvex(int v) {
    return points.orient(before(v), v, after(v)) > 0;
  }

  private boolean isEar(int b) {
    return isConvex(b) && reflex.isTriangleFree(before(b), b, after(b));
  }

  private void clip(int b) {
    int a = before(b);
    int c = after(b);
    corner[a] = dcel.splitFace(corner[a], corner[c]);
    left--;
    refresh(a);
    refresh(c);
  }

  /** After a neighbour of v is gone, its angle is smaller. */
  private void refresh(int v) {
    if (isConvex(v)) {
      reflex.remove(v);
    }
    enqueue(v);
  }

  /** Vertices in the order in which they came; each is in it at most once. */
  private static final class VertexQueue {
    private final int[] ring;
    private int head;
    private int size;

    VertexQueue(int capacity) {
      ring = new int[capacity];
    }

    void add(int v) {
      int tail = head + size++;
      ring[tail < ring.length ? tail : tail - ring.length] = v;
    }

    int remove() {
      int v = ring[head];
      head = head + 1 == ring.length ? 0 : head + 1;
      size--;
      return v;
    }
  }
}
