package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.Locale;

/**
 * A random strictly convex polygon, as n uniform random points are if they happen to be in convex
 * position (P. Valtr, "Probability that n random points are in convex position", 1995).
 *
 * <p>Random x-coordinates are dealt to a chain that goes right and one that goes back, which gives
 * the x-parts of the sides; their y-parts come in the same way; the parts are paired at random, and
 * the sides put in the order of their directions. Where two sides fall parallel, the y-part of one
 * is exchanged with that of a random side. O(n log n) expected time where there is ample room; real
 * coordinates have 2^50 places a side.
 */
final class ConvexPosition {
  private static final int ROUNDS = 300;

  private final SeededRandom random;
  private final long[] dx;
  private final long[] dy;
  private final Integer[] byDirection;

  private ConvexPosition(int n, Grid grid, SeededRandom random) {
    this.random = random;
    dx = sideParts(n, grid.columns());
    dy = sideParts(n, grid.rows());
    byDirection = new Integer[n];
    Arrays.setAll(byDirection, i -> i);
    shuffle();
  }

  /**
   * A counter-clockwise polygon of n vertices.
   *
   * @throws CannotGenerateException if none is found, as there is not room enough
   */
  static Points polygon(int n, Area area, SeededRandom random, Progress progress) {
    Grid grid = area.finestGrid();
    if (n > 2 * Math.min(grid.columns(), grid.rows())) {
      throw tooNarrow(n, area);
    }
    ConvexPosition sides = new ConvexPosition(n, grid, random);
    for (int round = 0; round < ROUNDS; round++) {
      progress.checkCancelled();
      if (sides.areStrict()) {
        return sides.sum(grid);
      }
    }
    throw tooNarrow(n, area);
  }

  private static CannotGenerateException tooNarrow(int n, Area area) {
    return new CannotGenerateException(
        String.format(
            Locale.ROOT,
            "no strictly convex polygon of %d vertices was found in %s; take a larger area or fewer",
            n,
            area));
  }

  /**
   * Random positive and negative steps that add up to zero, on a walk from 0 to size − 1. A line
   * meets a strictly convex polygon in two corners at most, hence each value comes at most twice,
   * and the second goes to the other chain.
   */
  private long[] sideParts(int n, long size) {
    long[] values = atMostTwice(n, size);
    long[] parts = new long[n];
    long[] reached = {values[0], values[0]}; // going and coming
    int chain = 0;
    for (int i = 1; i < n - 1; i++) {
      chain = values[i] == values[i - 1] ? 1 - chain : random.nextInt(2);
      long step = values[i] - reached[chain];
      parts[i - 1] = chain == 0 ? step : -step;
      reached[chain] = values[i];
    }
    parts[n - 2] = values[n - 1] - reached[0];
    parts[n - 1] = reached[1] - values[n - 1];
    return parts;
  }

  /** Random numbers from 0 to size − 1, sorted. */
  private long[] atMostTwice(int n, long size) {
    PlaceSet taken = new PlaceSet(new Grid(2 * size, 1, 0), n);
    long[] values = new long[n];
    for (int i = 0; i < n; ) {
      long half = random.nextLong(2 * size);
      values[i] = half / 2;
      i += taken.add(half, 0) ? 1 : 0;
    }
    Arrays.sort(values);
    return values;
  }

  private void shuffle() {
    for (int i = dy.length - 1; i > 0; i--) {
      exchange(i, random.nextInt(i + 1));
    }
  }

  private void exchange(int i, int j) {
    long kept = dy[i];
    dy[i] = dy[j];
    dy[j] = kept;
  }

  /** Sorts the sides; true if no two are parallel, or else changes those that are. */
  private boolean areStrict() {
    Arrays.sort(byDirection, this::compare);
    int n = dx.length;
    boolean strict = true;
    int before = byDirection[n - 1];
    for (int k = 0; k < n; k++) {
      int side = byDirection[k];
      if (Directions.turn(dx[before], dy[before], dx[side], dy[side]) <= 0) {
        exchange(side, random.nextInt(n));
        strict = false;
      }
      before = side;
    }
    return strict;
  }

  private int compare(int i, int j) {
    int zero = Boolean.compare(isZero(j), isZero(i)); // those first
    int direction = zero != 0 || isZero(i) ? zero : Directions.compare(dx[i], dy[i], dx[j], dy[j]);
    return direction != 0 ? direction : Integer.compare(i, j);
  }

  private boolean isZero(int side) {
    return dx[side] == 0 && dy[side] == 0;
  }

  /** The corners, moved to a random place within the area. */
  private Points sum(Grid grid) {
    int n = dx.length;
    long[] x = new long[n];
    long[] y = new long[n];
    for (int k = 1; k < n; k++) {
      x[k] = x[k - 1] + dx[byDirection[k - 1]];
      y[k] = y[k - 1] + dy[byDirection[k - 1]];
    }
    move(x, grid.columns());
    move(y, grid.rows());
    return grid.points(x, y);
  }

  private void move(long[] values, long size) {
    long least = Arrays.stream(values).min().orElseThrow();
    long largest = Arrays.stream(values).max().orElseThrow();
    long start = random.nextLong(size - (largest - least));
    for (int i = 0; i < values.length; i++) {
      values[i] += start - least;
    }
  }
}
