package dct.core.triangulate;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;

/**
 * Triangulates a simple polygon by cutting off ears (Meisters 1975; thesis, Algorithm 2.1), and a
 * region, too.
 *
 * <p>Takes any simple polygon or region. A corner b between a and c is an ear if abc turns strictly
 * left and no vertex of the rest whose angle is 180° or more lies in the closed triangle; so no
 * triangle is flat and no diagonal touches a vertex.
 *
 * <p>Of a region, holes, sites and fixed edges are first tied to the outer ring by as few diagonals
 * as do ({@link RegionTies}). Each face is then bounded by one closed walk, on which a vertex may
 * have several corners. All stays true: a corner with a convex angle is an ear of the face if no
 * vertex but a, b and c lies in the closed triangle; if one does, the corner of the one farthest
 * from the line ac that looks towards b has 180° or more. The ties are diagonals of the result.
 *
 * <p>Candidates wait in a queue, at first all corners of a face in their counter-clockwise order;
 * cutting an ear puts its two neighbours at the end. That is enough: the face only shrinks, so a
 * corner that is no ear can become one only when a neighbour of it goes. There are fewer than 3n
 * tests, each of which looks at the reflex vertices in the cells of a grid that the triangle's box
 * covers: O(n²) time at worst, close to O(n log n) on most polygons. O(n) space, exact.
 */
public final class EarClipping {
  private static final int LOOKS_BETWEEN_REPORTS = 1 << 14; // tests and what they look at

  private final Points points;
  private final Dcel dcel;
  private final int[] vertex; // by corner
  private final int[] leaving; // by corner: the half-edge that leaves it in the rest of its face
  private final int[] next; // by corner: the one after it in the rest of its face
  private final int[] previous;
  private final boolean[] reflex; // by corner: its angle is 180° or more
  private final int[] reflexCorners; // by vertex: how many of its corners are so
  private final boolean[] waiting; // by corner: is in the queue
  private final CornerQueue queue;
  private final ReflexGrid grid;
  private final Progress progress;
  private final int corners;
  private int clipped;
  private long tests;
  private long due; // at so many tests and looks a report

  private EarClipping(Region region, Progress progress) {
    this.progress = progress;
    points = region.points();
    dcel = region.isPolygon() ? Dcel.cycle(region.walk()) : RegionTies.tied(region, progress);
    corners = inner(dcel);
    vertex = new int[corners];
    leaving = new int[corners];
    next = new int[corners];
    previous = new int[corners];
    reflex = new boolean[corners];
    reflexCorners = new int[points.size()];
    waiting = new boolean[corners];
    queue = new CornerQueue(corners);
    findCorners();
    boolean[] isReflex = new boolean[points.size()];
    for (int v = 0; v < isReflex.length; v++) {
      isReflex[v] = reflexCorners[v] > 0;
    }
    grid = new ReflexGrid(points, isReflex);
  }

  private static int inner(Dcel dcel) {
    int count = 0;
    for (int e = 0; e < 2 * dcel.edgeBound(); e++) {
      count += dcel.face(e) == Dcel.OUTER ? 0 : 1;
    }
    return count;
  }

  private void findCorners() {
    int count = 0;
    for (int f = 1; f < dcel.faceBound(); f++) {
      int first = count;
      int start = dcel.faceEdge(f);
      int e = start;
      do {
        Progress.check(progress, count);
        vertex[count] = dcel.origin(e);
        leaving[count] = e;
        previous[count] = count - 1;
        next[count] = count + 1;
        count++;
        e = dcel.next(e);
      } while (e != start);
      previous[first] = count - 1;
      next[count - 1] = first;
    }
    for (int c = 0; c < corners; c++) {
      Progress.check(progress, c);
      reflex[c] = !isConvex(c);
      reflexCorners[vertex[c]] += reflex[c] ? 1 : 0;
    }
  }

  /**
   * A triangulation of a simple polygon.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Triangulation triangulate(SimplePolygon polygon, Progress progress) {
    return triangulate(Region.of(polygon), progress);
  }

  /**
   * A triangulation of a region.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Triangulation triangulate(Region region, Progress progress) {
    EarClipping run = new EarClipping(region, progress);
    for (int first = 0; first < run.corners; ) {
      first += run.clipFace(first);
    }
    return Triangulation.of(region, run.dcel, edge -> EdgeKind.DIAGONAL);
  }

  /** Triangulates the face whose corners start at this one; returns how many they are. */
  private int clipFace(int first) {
    int size = 1;
    for (int c = first; next[c] != first; c = next[c]) {
      size++;
    }
    for (int c = first; c < first + size; c++) {
      enqueue(c);
    }
    for (int left = size; left > 3; tests++) {
      if (tests + grid.looks() >= due) {
        due = tests + grid.looks() + LOOKS_BETWEEN_REPORTS;
        progress.checkCancelled();
        progress.report((double) clipped / corners, "Clipping ears");
      }
      int b = queue.remove();
      waiting[b] = false;
      if (isEar(b)) {
        clip(b);
        left--;
      }
    }
    while (queue.size > 0) {
      waiting[queue.remove()] = false;
    }
    return size;
  }

  private void enqueue(int corner) {
    if (!waiting[corner]) {
      waiting[corner] = true;
      queue.add(corner);
    }
  }

  private boolean isConvex(int c) {
    return points.orient(vertex[previous[c]], vertex[c], vertex[next[c]]) > 0;
  }

  private boolean isEar(int b) {
    return !reflex[b] && grid.isTriangleFree(vertex[previous[b]], vertex[b], vertex[next[b]]);
  }

  private void clip(int b) {
    int a = previous[b];
    int c = next[b];
    leaving[a] = dcel.splitFace(leaving[a], leaving[c]);
    next[a] = c;
    previous[c] = a;
    clipped++;
    refresh(a);
    refresh(c);
  }

  /** After a neighbour of it is gone, the angle of a corner is smaller. */
  private void refresh(int corner) {
    if (reflex[corner] && isConvex(corner)) {
      reflex[corner] = false;
      int v = vertex[corner];
      if (--reflexCorners[v] == 0) {
        grid.remove(v);
      }
    }
    enqueue(corner);
  }

  /** Corners in the order in which they came; each is in it at most once. */
  private static final class CornerQueue {
    private final int[] ring;
    private int head;
    private int size;

    CornerQueue(int capacity) {
      ring = new int[capacity];
    }

    void add(int corner) {
      int tail = head + size++;
      ring[tail < ring.length ? tail : tail - ring.length] = corner;
    }

    int remove() {
      int corner = ring[head];
      head = head + 1 == ring.length ? 0 : head + 1;
      size--;
      return corner;
    }
  }
}
