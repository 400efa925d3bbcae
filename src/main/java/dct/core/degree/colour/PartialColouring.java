package dct.core.degree.colour;

import java.util.Arrays;
import java.util.BitSet;

/**
 * Empty triangles of which some are known to be black, white or absent, and what follows from that.
 *
 * <p>The unknown 2t + c is 1 if triangle t is part of the triangulation and has the colour c, 0 for
 * black. At a side of sign 1 ({@link SignedSides}) a triangle has effectively the other colour. On
 * an inner edge the triangles that are effectively black on the left sum to those effectively white
 * on the right, and the other way round. On the boundary one triangle has effectively the colour of
 * the edge, and none the other: the first edge of the outer ring is black, that of each hole has an
 * unknown of its own, 1 if it is white, and along a ring the colour changes with each ray that is
 * crossed outside from edge to edge.
 *
 * <p>Claim: values 0 and 1 that fulfil all rows are the triangulations with exactly the given odd
 * vertices. Proof: let all be odd that shall be. The closed way round an inner vertex v through the
 * centres and midpoints has no other vertex inside; it crosses deg(v) edges, where the colour
 * changes, and an odd number of rays if v shall be odd, an even number otherwise; so colours can be
 * given round it, hence everywhere, and likewise along each ring. The other way: the number of
 * triangles over a point does not change across an edge and is 1 at the boundary, so those with the
 * value 1 are a triangulation, and the same ways show the parities. ∎
 *
 * <p>Two things follow from values known. Where the least or the greatest sum that a row can still
 * have is the one that it must have, all its unknowns are settled. And where a triangle is part of
 * the triangulation, none is that has an edge crossing one of its sides. Each value keeps its
 * reason: a row, a triangle that is crossed, or a {@link Core} learned before.
 */
final class PartialColouring {
  static final byte FREE = -1;
  static final int DECIDED = -1; // a reason
  static final int LEARNED = -2; // a reason
  private static final int CROSSED = -3; // this or less is a reason

  private final SignedSides sides;
  private final AllTriangles triangles;
  private final RowSums rows;
  private final byte[] sign; // by side
  private final byte[] value; // by unknown
  private final int[] reason; // by unknown
  private final int[] place; // by unknown, on the trail
  private final Core[] learned; // by unknown
  private final int[] trail; // unknowns in the order in which they became known
  private int size; // of the trail
  private int examined; // of the trail, for crossing triangles
  private final int[] absentBy; // by edge: an unknown that is 1 and crosses it, or NONE
  private final int[] absent; // edges, in the order in which they were excluded
  private int absentCount;
  private final int[] chosen; // unknowns that are 1
  private int chosenCount;
  private final int[] covered; // at 2e, 2e + 1: unknowns that are 1 on the left, right of edge e
  private final byte[] change; // by position of a hole's ring: its edge is not as the first one
  private int[] odd = {};
  private int faultRow; // of the last conflict, or NONE
  private int fault; // an unknown that is 1 …
  private int faultBy; // … and crosses this one, which is 1

  PartialColouring(SignedSides sides) {
    this.sides = sides;
    triangles = sides.triangles();
    rows = new RowSums(triangles);
    int unknowns = unknowns(sides);
    sign = new byte[3 * triangles.count()];
    value = new byte[unknowns];
    Arrays.fill(value, FREE);
    reason = new int[unknowns];
    place = new int[unknowns];
    learned = new Core[unknowns];
    trail = new int[unknowns];
    chosen = new int[unknowns];
    absentBy = new int[triangles.edges()];
    Arrays.fill(absentBy, SignedSides.NONE);
    absent = new int[triangles.edges()];
    covered = new int[2 * triangles.edges()];
    change = new byte[sides.boundary().size()];
    for (int k = 0; k < change.length; k++) {
      if (sides.boundary().ring(k) > 0) {
        int row = 2 * sides.outerEdge(k);
        rows.extend(row, addsRing(k, row));
        rows.extend(row ^ 1, addsRing(k, row ^ 1));
      }
    }
  }

  /** How many unknowns there are: two a triangle, then one a hole. */
  static int unknowns(SignedSides sides) {
    return 2 * sides.triangles().count() + sides.boundary().rings() - 1;
  }

  /** Forgets all values; takes the signs of these odd sites, and the rows of these edges only. */
  void begin(int[] nextOdd, BitSet edges) {
    undoTo(0);
    changeSigns(odd);
    changeSigns(nextOdd);
    odd = nextOdd;
    colourBoundary();
    rows.use(edges);
  }

  private void changeSigns(int[] sites) {
    for (int u : sites) {
      for (int side : sides.crossed(u)) {
        sign[side] ^= 1;
      }
    }
  }

  private void colourBoundary() {
    Boundary boundary = sides.boundary();
    BitSet changes = new BitSet(); // positions after whose edge the colour is another
    for (int u : odd) {
      for (int exit : boundary.exits(u)) {
        changes.flip(exit);
      }
    }
    int colour = 0;
    for (int k = 0; k < boundary.size(); k++) {
      colour = k == boundary.first(boundary.ring(k)) ? 0 : colour;
      if (boundary.ring(k) > 0 && change[k] != colour) {
        turn(k);
      }
      if (sides.outerEdge(k) != SignedSides.NONE) {
        int row = ringRow(k, colour);
        rows.want(row, sides.isForward(k) ? 1 : -1);
        rows.want(row ^ 1, 0);
      }
      colour ^= changes.get(k) ? 1 : 0;
    }
  }

  /** Gives the edge at a position of a hole's ring the other colour, compared with the first. */
  private void turn(int k) {
    int row = 2 * sides.outerEdge(k);
    boolean isAdded = addsRing(k, row);
    rows.shorten(row, isAdded);
    rows.shorten(row ^ 1, !isAdded);
    rows.extend(row, !isAdded);
    rows.extend(row ^ 1, isAdded);
    change[k] ^= 1;
  }

  /** The row in which triangles are that have this effective colour at a position. */
  private int ringRow(int k, int colour) {
    return 2 * sides.outerEdge(k) + (sides.isForward(k) ? colour : 1 - colour);
  }

  /** Whether the unknown of a ring is added in this row of the edge at a position. */
  boolean addsRing(int k, int row) {
    return (row == ringRow(k, change[k])) == sides.isForward(k);
  }

  /** The unknown of the hole on whose ring an edge is, or NONE. */
  int ringUnknown(int edge) {
    int k = sides.outerPosition(edge);
    int ring = k == SignedSides.NONE ? 0 : sides.boundary().ring(k);
    return ring == 0 ? SignedSides.NONE : 2 * triangles.count() + ring - 1;
  }

  /** Whether an unknown is that of a ring. */
  boolean isRing(int x) {
    return x >= 2 * triangles.count();
  }

  /** The row in which a triangle is wanted at a position; NONE while that is not known. */
  int wantedRow(int k) {
    int edge = sides.outerEdge(k);
    int x = ringUnknown(edge);
    if (x == SignedSides.NONE) {
      return rows.isWanted(2 * edge) ? 2 * edge : 2 * edge + 1;
    }
    return value[x] == FREE ? SignedSides.NONE : ringRow(k, value[x] ^ change[k]);
  }

  // ---- what is known

  /** The sides of the triangles. */
  SignedSides sides() {
    return sides;
  }

  /** The sums of the rows. */
  RowSums rows() {
    return rows;
  }

  /** The unknown that a side brings into a row of its edge. */
  int unknown(int side, int row) {
    return 2 * (side / 3) + ((row & 1) ^ sign[side] ^ (triangles.isForward(side) ? 0 : 1));
  }

  /** The row that an unknown is in on this side of its triangle. */
  int row(int x, int side) {
    int q = (x & 1) ^ sign[side] ^ (triangles.isForward(side) ? 0 : 1);
    return 2 * triangles.edge(side) + q;
  }

  /** 0, 1 or FREE. */
  int value(int x) {
    return value[x];
  }

  /** Why an unknown has its value: a row, DECIDED, LEARNED, or a crossing triangle. */
  int reason(int x) {
    return reason[x];
  }

  /** What an unknown's value rests on, its reason being LEARNED. */
  Core learned(int x) {
    return learned[x];
  }

  /** Whether this reason is a crossing triangle. */
  static boolean isCrossed(int reason) {
    return reason <= CROSSED;
  }

  /** The unknown of the crossing triangle that is this reason. */
  static int crossing(int reason) {
    return CROSSED - reason;
  }

  /** How many unknowns became known before this one. */
  int place(int x) {
    return place[x];
  }

  /** How many unknowns are known. */
  int size() {
    return size;
  }

  /** How many unknowns are 1. */
  int chosenCount() {
    return chosenCount;
  }

  /** The unknown that was the k-th to become 1. */
  int chosen(int k) {
    return chosen[k];
  }

  /** Whether a triangle on this side of an edge is chosen. */
  boolean isCovered(int edge, boolean left) {
    return covered[2 * edge + (left ? 0 : 1)] > 0;
  }

  /** The row that cannot be fulfilled any more, or NONE if two chosen triangles cross. */
  int faultRow() {
    return faultRow;
  }

  /** One of two unknowns that are 1 and exclude each other. */
  int fault() {
    return fault;
  }

  /** The other one. */
  int faultBy() {
    return faultBy;
  }

  // ---- giving values

  /** Makes a free unknown 1, to see what follows. */
  void decide(int x) {
    set(x, 1, DECIDED);
  }

  /** Makes a free unknown 0 for a reason found before. */
  void exclude(int x, Core core) {
    learned[x] = core;
    set(x, 0, LEARNED);
  }

  private void set(int x, int to, int why) {
    value[x] = (byte) to;
    reason[x] = why;
    place[x] = size;
    trail[size++] = x;
    if (isRing(x)) {
      noteRing(x, to == 1, true);
      return;
    }
    if (to == 1) {
      chosen[chosenCount++] = x;
    }
    int first = x / 2 * 3;
    for (int side = first; side < first + 3; side++) {
      boolean isForward = triangles.isForward(side);
      covered[2 * triangles.edge(side) + (isForward ? 0 : 1)] += to;
      rows.narrow(row(x, side), isForward == (to == 1));
    }
  }

  /** Tells the rows along a ring that its unknown is known, or no longer known. */
  private void noteRing(int x, boolean isOne, boolean isKnown) {
    Boundary boundary = sides.boundary();
    int first = boundary.first(x - 2 * triangles.count() + 1);
    int k = first;
    do {
      for (int row = 2 * sides.outerEdge(k); row < 2 * sides.outerEdge(k) + 2; row++) {
        boolean raises = addsRing(k, row) == isOne;
        if (isKnown) {
          rows.narrow(row, raises);
        } else {
          rows.widen(row, raises);
        }
      }
      k = boundary.after(k);
    } while (k != first);
  }

  /** Takes values back, so that this many remain. */
  void undoTo(int remaining) {
    rows.clear();
    while (absentCount > 0 && place[absentBy[absent[absentCount - 1]]] >= remaining) {
      absentBy[absent[--absentCount]] = SignedSides.NONE;
    }
    while (size > remaining) {
      undoLast();
    }
    examined = Math.min(examined, size);
  }

  private void undoLast() {
    int x = trail[--size];
    int was = value[x];
    if (isRing(x)) {
      noteRing(x, was == 1, false);
      value[x] = FREE;
      return;
    }
    chosenCount -= was;
    int first = x / 2 * 3;
    for (int side = first; side < first + 3; side++) {
      boolean isForward = triangles.isForward(side);
      covered[2 * triangles.edge(side) + (isForward ? 0 : 1)] -= was;
      rows.widen(row(x, side), isForward == (was == 1));
    }
    value[x] = FREE;
  }

  // ---- what follows

  /** Draws all conclusions; false if there is a conflict. */
  boolean propagate() {
    while (rows.isWaiting() || examined < size) {
      boolean holds;
      if (rows.isWaiting()) {
        holds = settle(rows.next());
      } else {
        int x = trail[examined++];
        holds = value[x] == 0 || isRing(x) || excludeCrossed(x);
      }
      if (!holds) {
        rows.clear();
        return false;
      }
    }
    return true;
  }

  private boolean settle(int row) {
    if (rows.isBroken(row)) {
      faultRow = row;
      return false;
    }
    if (!rows.isSettled(row)) {
      boolean isLow = rows.isLow(row);
      for (int side : triangles.sidesOn(row >> 1)) {
        int x = unknown(side, row);
        if (value[x] == FREE) {
          set(x, triangles.isForward(side) == isLow ? 0 : 1, row);
        }
      }
      int x = ringUnknown(row >> 1);
      if (x != SignedSides.NONE && value[x] == FREE) {
        set(x, addsRing(sides.outerPosition(row >> 1), row) == isLow ? 0 : 1, row);
      }
    }
    return true;
  }

  private boolean excludeCrossed(int x) {
    boolean holds = excludeFor(x, x ^ 1);
    int first = x / 2 * 3;
    for (int side = first; holds && side < first + 3; side++) {
      for (int f : sides.crossing(triangles.edge(side))) {
        holds = holds && (absentBy[f] != SignedSides.NONE || excludeEdge(x, f));
      }
    }
    return holds;
  }

  private boolean excludeEdge(int x, int edge) {
    absentBy[edge] = x;
    absent[absentCount++] = edge;
    for (int side : triangles.sidesOn(edge)) {
      int y = 2 * (side / 3);
      if (!excludeFor(x, y) || !excludeFor(x, y + 1)) {
        return false;
      }
    }
    return true;
  }

  private boolean excludeFor(int x, int y) {
    if (value[y] == 1) {
      faultRow = SignedSides.NONE;
      faultBy = x;
      fault = y;
      return false;
    }
    if (value[y] == FREE) {
      set(y, 0, CROSSED - x);
    }
    return true;
  }
}
