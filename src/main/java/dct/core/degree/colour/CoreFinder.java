package dct.core.degree.colour;

import java.util.BitSet;

/** Follows a conflict back to the decisions and the signs of sides that it rests on. */
final class CoreFinder {
  private final PartialColouring colouring;
  private final AllTriangles triangles;
  private final int[] level; // by unknown that was decided
  private final boolean[] isSeen; // by unknown
  private final int[] seen;
  private final int[] rowSeen; // by row: in which search for a core it was seen as a reason
  private int searches;
  private int seenCount;
  private BitSet levels;
  private BitSet sides;

  CoreFinder(PartialColouring colouring, AllTriangles triangles) {
    this.colouring = colouring;
    this.triangles = triangles;
    int unknowns = PartialColouring.unknowns(colouring.sides());
    level = new int[unknowns];
    isSeen = new boolean[unknowns];
    seen = new int[unknowns];
    rowSeen = new int[2 * triangles.edges()];
  }

  /** Notes the level at which an unknown is decided. */
  void decided(int x, int atLevel) {
    level[x] = atLevel;
  }

  /** What the conflict rests on that was found last. */
  Core core() {
    levels = new BitSet();
    sides = new BitSet();
    seenCount = 0;
    searches++;
    int row = colouring.faultRow();
    if (row == SignedSides.NONE) {
      see(colouring.fault());
      see(colouring.faultBy());
    } else {
      seeRow(row, colouring.rows().isLow(row), Integer.MAX_VALUE);
    }
    for (int k = 0; k < seenCount; k++) {
      follow(seen[k]);
    }
    for (int k = 0; k < seenCount; k++) {
      isSeen[seen[k]] = false;
    }
    return new Core(levels, sides);
  }

  private void see(int x) {
    if (!isSeen[x]) {
      isSeen[x] = true;
      seen[seenCount++] = x;
    }
  }

  private void follow(int x) {
    int reason = colouring.reason(x);
    if (reason == PartialColouring.DECIDED) {
      levels.set(level[x]);
    } else if (reason == PartialColouring.LEARNED) {
      levels.or(colouring.learned(x).levels());
      sides.or(colouring.learned(x).sides());
    } else if (PartialColouring.isCrossed(reason)) {
      see(PartialColouring.crossing(reason));
    } else {
      followRow(x, reason);
    }
  }

  private void followRow(int x, int row) {
    if (colouring.isRing(x)) {
      boolean adds = colouring.addsRing(colouring.sides().outerPosition(row >> 1), row);
      seeRow(row, adds == (colouring.value(x) == 0), colouring.place(x));
      return;
    }
    for (int side = x / 2 * 3; side < x / 2 * 3 + 3; side++) {
      if (triangles.edge(side) == row >> 1) {
        sides.set(side);
        if (rowSeen[row] != searches) { // all that a row settled rests on the same
          rowSeen[row] = searches;
          boolean isLow = triangles.isForward(side) == (colouring.value(x) == 0);
          seeRow(row, isLow, colouring.place(x));
        }
      }
    }
  }

  /** The values before this place that raised the least sum of a row, or lowered the greatest. */
  private void seeRow(int row, boolean isLow, int before) {
    int ring = colouring.ringUnknown(row >> 1);
    if (ring != SignedSides.NONE && isKnown(ring, before)) {
      boolean adds = colouring.addsRing(colouring.sides().outerPosition(row >> 1), row);
      if (isLow == (adds == (colouring.value(ring) == 1))) {
        see(ring);
      }
    }
    for (int side : triangles.sidesOn(row >> 1)) {
      int x = colouring.unknown(side, row);
      if (isKnown(x, before) && isLow == (triangles.isForward(side) == (colouring.value(x) == 1))) {
        see(x);
        if (!isAbsent(x, before)) {
          sides.set(side);
        }
      }
    }
  }

  private boolean isKnown(int x, int before) {
    return colouring.value(x) != PartialColouring.FREE && colouring.place(x) < before;
  }

  /** Whether one reason excludes the triangle in both colours, so that signs do not matter. */
  private boolean isAbsent(int x, int before) {
    int other = x ^ 1;
    return colouring.value(x) == 0
        && colouring.value(other) == 0
        && isKnown(other, before)
        && PartialColouring.isCrossed(colouring.reason(x))
        && colouring.reason(x) == colouring.reason(other);
  }
}
