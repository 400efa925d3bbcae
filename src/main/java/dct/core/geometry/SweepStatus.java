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
  private final double[]
      ends; // by 4·edge: x, y of the end that the line meets first, and of the other
  private final int[] before; // the edge to the left in the list
  private final int[] after; // the edge to the right in the list
  private final int[] child; // in the tree: by 2·edge the left one, by 2·edge + 1 the right one
  private final int[] parent;
  private final int[] priority; // no child has a higher one than its parent
  private int root = NONE;
  private int first = NONE;
  private int touched = NONE;

  /** An empty status for edges 0 … capacity − 1 between these points. */
  public SweepStatus(Points points, int capacity) {
    this.points = points;
    ends = new double[4 * capacity];
    before = new int[capacity];
    after = new int[capacity];
    child = new int[2 * capacity];
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
    double x = points.x(v);
    double y = points.y(v);
    while (edge != NONE) {
      int i = 4 * edge;
      int side = Predicates.orient(ends[i], ends[i + 1], ends[i + 2], ends[i + 3], x, y);
      if (side > 0) {
        found = edge;
        edge = child[2 * edge + 1];
      } else {
        touched = side == 0 ? edge : touched;
        edge = child[2 * edge];
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
    place(edge, upperEnd, lowerEnd);
    child[2 * edge] = NONE;
    child[2 * edge + 1] = NONE;
    priority[edge] = hash(edge);
    int rightNeighbour = after(leftNeighbour);
    thread(leftNeighbour, edge);
    thread(edge, rightNeighbour);
    if (leftNeighbour != NONE && child[2 * leftNeighbour + 1] == NONE) {
      child[2 * leftNeighbour + 1] = edge;
      parent[edge] = leftNeighbour;
    } else if (rightNeighbour != NONE) {
      child[2 * rightNeighbour] = edge; // free: its predecessor has a right child, or there is none
      parent[edge] = rightNeighbour;
    } else {
      root = edge;
      parent[edge] = NONE;
    }
    while (parent[edge] != NONE && priority[parent[edge]] < priority[edge]) {
      rotateUp(edge);
    }
  }

  /** Copies the ends of an edge, so that a search finds all it needs of one in one place. */
  private void place(int edge, int upperEnd, int lowerEnd) {
    ends[4 * edge] = points.x(upperEnd);
    ends[4 * edge + 1] = points.y(upperEnd);
    ends[4 * edge + 2] = points.x(lowerEnd);
    ends[4 * edge + 3] = points.y(lowerEnd);
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
    place(edge, upperEnd, lowerEnd);
    child[2 * edge] = child[2 * old];
    child[2 * edge + 1] = child[2 * old + 1];
    priority[edge] = priority[old];
    thread(before[old], edge);
    thread(edge, after[old]);
    putInPlaceOf(old, edge);
    adopt(edge, child[2 * edge]);
    adopt(edge, child[2 * edge + 1]);
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
    } else {
      child[2 * above + sideOf(old, above)] = edge;
    }
    if (edge != NONE) {
      parent[edge] = above;
    }
  }

  /** Removes an edge. */
  public void remove(int edge) {
    thread(before[edge], after[edge]);
    while (child[2 * edge] != NONE && child[2 * edge + 1] != NONE) {
      int l = child[2 * edge];
      int r = child[2 * edge + 1];
      rotateUp(priority[l] > priority[r] ? l : r);
    }
    putInPlaceOf(edge, child[2 * edge] != NONE ? child[2 * edge] : child[2 * edge + 1]);
  }

  private void rotateUp(int edge) {
    int above = parent[edge];
    int side = sideOf(edge, above);
    int between = child[2 * edge + 1 - side];
    putInPlaceOf(above, edge);
    child[2 * above + side] = between;
    adopt(above, between);
    child[2 * edge + 1 - side] = above;
    parent[above] = edge;
  }

  /** 0 if the edge is a left child, 1 if it is a right one. */
  private int sideOf(int edge, int above) {
    return child[2 * above] == edge ? 0 : 1;
  }

  /** The finalizer of MurmurHash3: every bit of the edge reaches every bit of the priority. */
  private static int hash(int edge) {
    int h = edge + 0x9e3779b9;
    h = (h ^ (h >>> 16)) * 0x85ebca6b;
    h = (h ^ (h >>> 13)) * 0xc2b2ae35;
    return h ^ (h >>> 16);
  }
}
