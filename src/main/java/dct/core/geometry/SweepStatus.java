package dct.core.geometry;

import java.util.Arrays;

/**
 * The edges that a downward sweep line crosses, from left to right: the list that the thesis calls
 * £ (Section 2.2.4).
 *
 * <p>Edges are ints chosen by the caller. The line is level but for an infinitesimal angle, so that
 * it meets points in the reverse of {@link PlaneOrder} and level edges need no special case. As
 * long as no two edges cross above the line, the order is that in which it meets them.
 *
 * <p>A treap (Seidel and Aragon 1996) threaded by a list: {@link #search} and the updates take
 * O(log n) expected time, a step to a neighbour and {@link #replace} O(1). Priorities are a fixed
 * hash of the edge, so that runs repeat exactly.
 */
public final class SweepStatus {
  /** No edge. */
  public static final int NONE = -1;

  private final Points points;
  private final int[] upper; // the end of the edge that the line meets first
  private final int[] lower; // the other end
  private final int[] before; // the edge to the left in the list
  private final int[] after; // the edge to the right in the list
  private final int[] left; // children and parent in the tree
  private final int[] right;
  private final int[] parent;
  private final int[] priority; // no child has a higher one than its parent
  private int root = NONE;
  private int first = NONE;
  private int touched = NONE;

  /** An empty status for edges 0 … capacity − 1 between these points. */
  public SweepStatus(Points points, int capacity) {
    this.points = points;
    upper = new int[capacity];
    lower = new int[capacity];
    before = new int[capacity];
    after = new int[capacity];
    left = new int[capacity];
    right = new int[capacity];
    parent = new int[capacity];
    priority = new int[capacity];
    Arrays.fill(parent, NONE);
  }

  /**
   * The last edge to the left of point v, or {@link #NONE}. If v lies on an edge, that edge is
   * {@link #touched()} afterwards, and the answer is the edge before it.
   */
  public int search(int v) {
    touched = NONE;
    int found = NONE;
    int edge = root;
    while (edge != NONE) {
      int side = points.orient(upper[edge], lower[edge], v);
      if (side > 0) {
        found = edge;
        edge = right[edge];
      } else {
        if (side == 0) {
          touched = edge;
        }
        edge = left[edge];
      }
    }
    return found;
  }

  /** The edge on which the point last searched for lies, or {@link #NONE}. */
  public int touched() {
    return touched;
  }

  /** The edge to the left of this one, or {@link #NONE}. */
  public int before(int edge) {
    return before[edge];
  }

  /** The edge to the right of this one, the first one if it is {@link #NONE}, or none. */
  public int after(int edge) {
    return edge == NONE ? first : after[edge];
  }

  /** Inserts an edge, given by the end that the line meets first and the other one. */
  public void insertAfter(int leftNeighbour, int edge, int upperEnd, int lowerEnd) {
    upper[edge] = upperEnd;
    lower[edge] = lowerEnd;
    left[edge] = NONE;
    right[edge] = NONE;
    priority[edge] = hash(edge);
    int rightNeighbour = after(leftNeighbour);
    thread(leftNeighbour, edge);
    thread(edge, rightNeighbour);
    if (leftNeighbour != NONE && right[leftNeighbour] == NONE) {
      right[leftNeighbour] = edge;
      parent[edge] = leftNeighbour;
    } else if (rightNeighbour != NONE) {
      left[rightNeighbour] = edge; // free: its predecessor has a right child, or there is none
      parent[edge] = rightNeighbour;
    } else {
      root = edge;
      parent[edge] = NONE;
    }
    while (parent[edge] != NONE && priority[parent[edge]] < priority[edge]) {
      rotateUp(edge);
    }
  }

  private void thread(int leftEdge, int rightEdge) {
    if (leftEdge == NONE) {
      first = rightEdge;
    } else {
      after[leftEdge] = rightEdge;
    }
    if (rightEdge != NONE) {
      before[rightEdge] = leftEdge;
    }
  }

  /** Puts an edge that starts where {@code old} ends into the place of that one. */
  public void replace(int old, int edge, int upperEnd, int lowerEnd) {
    upper[edge] = upperEnd;
    lower[edge] = lowerEnd;
    left[edge] = left[old];
    right[edge] = right[old];
    priority[edge] = priority[old];
    thread(before[old], edge);
    thread(edge, after[old]);
    putInPlaceOf(old, edge);
    adopt(edge, left[edge]);
    adopt(edge, right[edge]);
  }

  private void adopt(int edge, int child) {
    if (child != NONE) {
      parent[child] = edge;
    }
  }

  /** Makes {@code edge} the child that {@code old} was. */
  private void putInPlaceOf(int old, int edge) {
    int above = parent[old];
    if (above == NONE) {
      root = edge;
    } else if (left[above] == old) {
      left[above] = edge;
    } else {
      right[above] = edge;
    }
    if (edge != NONE) {
      parent[edge] = above;
    }
  }

  /** Removes an edge. */
  public void remove(int edge) {
    thread(before[edge], after[edge]);
    while (left[edge] != NONE && right[edge] != NONE) {
      int l = left[edge];
      int r = right[edge];
      rotateUp(priority[l] > priority[r] ? l : r);
    }
    putInPlaceOf(edge, left[edge] != NONE ? left[edge] : right[edge]);
  }

  private void rotateUp(int edge) {
    int above = parent[edge];
    putInPlaceOf(above, edge);
    if (left[above] == edge) {
      left[above] = right[edge];
      adopt(above, right[edge]);
      right[edge] = above;
    } else {
      right[above] = left[edge];
      adopt(above, left[edge]);
      left[edge] = above;
    }
    parent[above] = edge;
  }

  /** The finalizer of MurmurHash3: every bit of the edge reaches every bit of the priority. */
  private static int hash(int edge) {
    int h = edge + 0x9e3779b9;
    h = (h ^ (h >>> 16)) * 0x85ebca6b;
    h = (h ^ (h >>> 13)) * 0xc2b2ae35;
    return h ^ (h >>> 16);
  }
}
