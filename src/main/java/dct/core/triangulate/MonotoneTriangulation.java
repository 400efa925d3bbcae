package dct.core.triangulate;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;

/**
 * Triangulates a simple polygon or a region by way of its monotone pieces (thesis, Algorithms 2.2
 * and 2.3).
 *
 * <p>Takes any simple polygon or region. Returns a triangulation whose diagonals of the partition
 * are of kind {@link EdgeKind#PARTITION}. The partition takes O(n log n) time ({@link
 * MonotonePartition}); the pieces are triangulated in linear time, after Garey, Johnson, Preparata
 * and Tarjan (1978): the two chains of a piece are merged, not sorted, and a stack holds the
 * vertices that still wait, a reflex chain. Exact; a triangle is cut off only where its area is
 * positive.
 */
public final class MonotoneTriangulation {
  private final Points points;
  private final Dcel dcel;
  private final int[] stack; // half-edges that leave the waiting vertices, in the face that is left
  private int top; // of the stack
  private boolean leftChain; // the waiting vertices are on the left chain

  private final Progress progress;
  private int merged; // so many vertices of pieces

  private MonotoneTriangulation(Points points, Dcel dcel, Progress progress) {
    this.progress = progress;
    this.points = points;
    this.dcel = dcel;
    stack = new int[points.size()];
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
    Dcel dcel = MonotonePartition.partition(region, progress).dcel().copy();
    int partitionEdges = dcel.edgeCount();
    int pieces = dcel.faceBound();
    MonotoneTriangulation run = new MonotoneTriangulation(region.points(), dcel, progress);
    for (int f = 1; f < pieces; f++) {
      Progress.tick(progress, f - 1, pieces, "Triangulating the monotone pieces");
      run.triangulatePiece(dcel.faceEdge(f));
    }
    return Triangulation.of(
        region, dcel, edge -> edge < partitionEdges ? EdgeKind.PARTITION : EdgeKind.DIAGONAL);
  }

  /** Triangulates one monotone face, given by any of its half-edges. */
  private void triangulatePiece(int anyEdge) {
    int highest = highest(anyEdge);
    int left = dcel.next(highest); // half-edge that leaves the next vertex of the left chain
    int right = dcel.prev(highest); // half-edge that leaves the next vertex of the right chain
    top = 0;
    stack[0] = highest;
    boolean first = true;
    while (left != right) {
      Progress.check(progress, merged++);
      boolean takeLeft = isAbove(dcel.origin(left), dcel.origin(right));
      int corner = takeLeft ? left : right;
      if (takeLeft) {
        left = dcel.next(left);
      } else {
        right = dcel.prev(right);
      }
      if (first || takeLeft == leftChain) {
        first = false;
        leftChain = takeLeft;
        waitOnChain(corner);
      } else {
        crossOver(corner, top);
        leftChain = takeLeft;
      }
    }
    closeAtLowest(left);
  }

  private int highest(int start) {
    int highest = start;
    for (int e = dcel.next(start); e != start; e = dcel.next(e)) {
      if (isAbove(dcel.origin(e), dcel.origin(highest))) {
        highest = e;
      }
    }
    return highest;
  }

  private boolean isAbove(int v, int w) {
    return points.yxLess(w, v);
  }

  /**
   * The vertex of {@code corner} is on the chain of those that wait (Cases 1 and 2): joins it to
   * them while the angle between is convex.
   */
  private void waitOnChain(int corner) {
    int mine = corner;
    while (top > 0 && isConvex(stack[top - 1], stack[top], mine)) {
      int below = stack[top - 1];
      if (leftChain) {
        stack[top - 1] = dcel.splitFace(below, mine);
      } else {
        mine = dcel.splitFace(mine, below);
      }
      top--;
    }
    stack[++top] = mine;
  }

  private boolean isConvex(int older, int waiting, int current) {
    int turn = points.orient(dcel.origin(older), dcel.origin(waiting), dcel.origin(current));
    return leftChain ? turn > 0 : turn < 0;
  }

  /**
   * The vertex of {@code corner} is on the other chain (Case 3): joins it to the waiting vertices 1
   * … last; then only the one that waited last and this one wait.
   */
  private void crossOver(int corner, int last) {
    int mine = corner;
    for (int w = 1; w <= last; w++) {
      if (leftChain) {
        mine = dcel.splitFace(mine, stack[w]);
      } else {
        stack[w] = dcel.splitFace(mine, stack[w]) ^ 1;
      }
    }
    stack[0] = stack[top];
    stack[1] = mine;
    top = 1;
  }

  /** The lowest vertex neighbours the first and the last of those that wait. */
  private void closeAtLowest(int corner) {
    crossOver(corner, top - 1);
  }
}
