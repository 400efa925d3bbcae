package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;
import java.util.Arrays;

/**
 * A random star-shaped polygon: random points in angular order about the centroid of three random
 * ones of them, which sees the whole polygon (the "Star" heuristic of T. Auer and M. Held,
 * "Heuristics for the generation of random polygons", 1996).
 *
 * <p>The centroid lies strictly inside the convex hull, so that less than half a turn separates
 * neighbours; if it is one of the points, others are drawn. Points in the same direction come with
 * the nearest first. O(n log n) time.
 */
final class StarShaped {
  private final Places p;
  private final long cx; // three times the centre
  private final long cy;

  /** Draws the centre. */
  StarShaped(Places places, SeededRandom random) {
    this.p = places;
    int a;
    int b;
    int c;
    do {
      a = random.nextInt(p.size());
      b = random.nextInt(p.size());
      c = random.nextInt(p.size());
    } while (p.turn(a, b, c) == 0 || isPoint(a, b, c));
    cx = (long) p.x(a) + p.x(b) + p.x(c);
    cy = (long) p.y(a) + p.y(b) + p.y(c);
  }

  /** A counter-clockwise polygon of n vertices. */
  static Points polygon(int n, Area area, SeededRandom random, Progress progress) {
    Places places = Places.spread(n, area.grid(), random);
    return places.points(new StarShaped(places, random).order());
  }

  /** Three times the x-coordinate of the centre, as a place. */
  long centreX() {
    return cx;
  }

  /** Three times the y-coordinate of the centre, as a place. */
  long centreY() {
    return cy;
  }

  private boolean isPoint(int a, int b, int c) {
    long x = (long) p.x(a) + p.x(b) + p.x(c);
    long y = (long) p.y(a) + p.y(b) + p.y(c);
    for (int i = 0; i < p.size(); i++) {
      if (3L * p.x(i) == x && 3L * p.y(i) == y) {
        return true;
      }
    }
    return false;
  }

  private int[] order() {
    Integer[] order = new Integer[p.size()];
    Arrays.setAll(order, i -> i);
    Arrays.sort(order, this::compare);
    return Arrays.stream(order).mapToInt(i -> i).toArray();
  }

  private int compare(int i, int j) {
    long ix = 3L * p.x(i) - cx;
    long iy = 3L * p.y(i) - cy;
    long jx = 3L * p.x(j) - cx;
    long jy = 3L * p.y(j) - cy;
    int direction = Directions.compare(ix, iy, jx, jy);
    return direction != 0
        ? direction
        : Long.compare(Math.abs(ix) + Math.abs(iy), Math.abs(jx) + Math.abs(jy));
  }
}
