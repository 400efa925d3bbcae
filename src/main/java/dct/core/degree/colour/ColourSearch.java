package dct.core.degree.colour;

import dct.core.Progress;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/**
 * Finds a triangulation with exactly some odd vertices, or what shows that there is none.
 *
 * <p>Where nothing follows from what is known, a triangle is chosen on an edge that lacks one, on
 * that edge which has the fewest left; before that the first colour of a hole's ring, which settles
 * much. From a conflict the search goes back to the last choice that it rests on, and excludes it.
 */
final class ColourSearch {
  /** How a search ended. */
  enum Outcome {
    FOUND,
    REFUTED,
    GIVEN_UP
  }

  private static final int RING_COLOURS = 2;

  private final SignedSides sides;
  private final AllTriangles triangles;
  private final PartialColouring colouring;
  private final CoreFinder finder;
  private final List<Integer> sizes = new ArrayList<>(); // by level: of the trail before
  private final List<Integer> decisions = new ArrayList<>(); // by level
  private Core refutation;
  private long steps;
  private int fewest;
  private int next;

  ColourSearch(SignedSides sides) {
    this.sides = sides;
    triangles = sides.triangles();
    colouring = new PartialColouring(sides);
    finder = new CoreFinder(colouring, triangles);
  }

  /**
   * Searches for a triangulation whose odd vertices are these.
   *
   * @param edges the rows that count; if not all, what is found need not be a triangulation
   * @param mostSteps give up after about so many values and looks at sides
   */
  Outcome search(int[] odd, BitSet edges, long mostSteps, Progress progress) {
    colouring.begin(odd, edges);
    sizes.clear();
    decisions.clear();
    long limit = steps + mostSteps;
    while (true) {
      progress.checkCancelled();
      int before = colouring.size();
      boolean holds = colouring.propagate();
      steps += colouring.size() - before;
      if (!holds && !goBack()) {
        return Outcome.REFUTED;
      }
      if (holds && steps > limit) {
        return Outcome.GIVEN_UP;
      }
      if (holds && !decide()) {
        return Outcome.FOUND;
      }
    }
  }

  /** Excludes the last decision that a conflict rests on; false if it rests on none. */
  private boolean goBack() {
    Core core = finder.core();
    int last = core.levels().length() - 1;
    if (last < 0) {
      refutation = core;
      return false;
    }
    int x = decisions.get(last);
    colouring.undoTo(sizes.get(last));
    sizes.subList(last, sizes.size()).clear();
    decisions.subList(last, decisions.size()).clear();
    colouring.exclude(x, core.without(last));
    return true;
  }

  /** Chooses a triangle; false if no edge lacks one. */
  private boolean decide() {
    next = SignedSides.NONE;
    fewest = Integer.MAX_VALUE;
    offerBoundary();
    offerInside();
    if (next == SignedSides.NONE) {
      return false;
    }
    finder.decided(next, sizes.size());
    sizes.add(colouring.size());
    decisions.add(next);
    colouring.decide(next);
    return true;
  }

  private void offerBoundary() {
    for (int k = 0; k < sides.boundary().size(); k++) {
      int e = sides.outerEdge(k);
      if (e != SignedSides.NONE && !colouring.isCovered(e, sides.isForward(k))) {
        int row = colouring.wantedRow(k);
        if (row == SignedSides.NONE) {
          offerRing(colouring.ringUnknown(e));
        } else {
          offer(row, sides.isForward(k));
        }
      }
    }
  }

  /** Offers the colour of a hole's ring, one of two. */
  private void offerRing(int x) {
    if (fewest > RING_COLOURS) {
      fewest = RING_COLOURS;
      next = x;
    }
  }

  private void offerInside() {
    for (int k = 0; k < colouring.chosenCount(); k++) {
      int x = colouring.chosen(k);
      for (int side = x / 2 * 3; side < x / 2 * 3 + 3; side++) {
        int e = triangles.edge(side);
        boolean opposite = !triangles.isForward(side);
        if (!sides.isOuter(e) && !colouring.isCovered(e, opposite)) {
          offer(colouring.row(x, side), opposite);
        }
      }
    }
  }

  /** Offers the unknowns of a row on one side of its edge, where one must be 1. */
  private void offer(int row, boolean left) {
    if (!colouring.rows().isUsed(row >> 1)) {
      return;
    }
    int free = 0;
    int first = SignedSides.NONE;
    for (int side : triangles.sidesOn(row >> 1)) {
      int x = colouring.unknown(side, row);
      if (triangles.isForward(side) == left && colouring.value(x) == PartialColouring.FREE) {
        free++;
        first = first == SignedSides.NONE ? x : first;
      }
    }
    steps += triangles.sidesOn(row >> 1).length;
    if (free < fewest) {
      fewest = free;
      next = first;
    }
  }

  /** After FOUND with all rows: three sites a triangle, counter-clockwise. */
  int[] corners() {
    int[] corners = new int[3 * colouring.chosenCount()];
    for (int k = 0; k < corners.length; k++) {
      corners[k] = triangles.corner(colouring.chosen(k / 3) / 2 * 3 + k % 3);
    }
    return corners;
  }

  /** After REFUTED: what that rests on. */
  Core refutation() {
    return refutation;
  }

  /** All steps so far. */
  long steps() {
    return steps;
  }
}
