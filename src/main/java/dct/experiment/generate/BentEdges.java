package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.SimplicityCheck;

/**
 * A random polygon of few vertices ({@link Untangling}) whose edges are bent into arcs, all
 * outwards or all inwards. Bent outwards it has large convex parts, as in the thesis's Figure 3.9;
 * bent inwards reflex chains, as in its Figure 3.11. So the share of reflex vertices takes all
 * values, where other random polygons have about one half.
 *
 * <p>The number of vertices of the first polygon is uniform from 3 to n; the others fall on its
 * edges at random and lie on parabolas, equally spaced along the edge. All arcs have the same
 * height for the length of their edge: a quarter, halved until the polygon is simple and within the
 * area. Real coordinates only. O(n log n) time for each height tried, of which there are {@value
 * #TRIES} at most.
 */
final class BentEdges {
  private static final double HIGHEST = 0.25;
  private static final int TRIES = 32;

  private final Points base;
  private final int[] inner; // how many vertices are on each edge of the base
  private final int n;
  private final boolean outwards;

  private BentEdges(Points base, int n, SeededRandom random) {
    this.base = base;
    this.n = n;
    outwards = random.nextInt(2) == 0;
    inner = new int[base.size()];
    for (int k = base.size(); k < n; k++) {
      inner[random.nextInt(inner.length)]++;
    }
  }

  /**
   * A counter-clockwise polygon of n vertices.
   *
   * @throws CannotGenerateException if the coordinates have to be whole, or none was found
   */
  static Points polygon(int n, Area area, SeededRandom random, Progress progress) {
    if (area.whole()) {
      throw new CannotGenerateException(
          "bent edges need real coordinates; allow them, or use another shape");
    }
    int few = 3 + random.nextInt(n - 2);
    Points base = Untangling.fromRandomTour(few, area, random, progress);
    return new BentEdges(base, n, random).bent(area, progress);
  }

  private Points bent(Area area, Progress progress) {
    double height = HIGHEST;
    for (int i = 0; i < TRIES; i++) {
      progress.checkCancelled();
      Points points = bent(outwards ? height : -height);
      if (isWithin(points, area) && isCounterClockwise(points, progress)) {
        return points;
      }
      height /= 2;
    }
    throw new CannotGenerateException(
        "no polygon of " + n + " vertices with bent edges was found; use another seed");
  }

  private Points bent(double height) {
    double[] x = new double[n];
    double[] y = new double[n];
    int k = 0;
    for (int a = 0; a < inner.length; a++) {
      int b = a + 1 == inner.length ? 0 : a + 1;
      double dx = base.x(b) - base.x(a);
      double dy = base.y(b) - base.y(a);
      for (int i = 0; i <= inner[a]; i++) {
        double t = i / (inner[a] + 1.0);
        double out = 4 * height * t * (1 - t);
        x[k] = base.x(a) + t * dx + out * dy;
        y[k++] = base.y(a) + t * dy - out * dx;
      }
    }
    return Points.of(x, y);
  }

  /** Whether the polygon is simple, and was not turned inside out by arcs that all cross it. */
  private static boolean isCounterClockwise(Points points, Progress progress) {
    return SimplicityCheck.firstDefect(points, progress).isEmpty()
        && !SimplePolygon.of(points, progress).isClockwise();
  }

  private static boolean isWithin(Points points, Area area) {
    boolean within = true;
    for (int i = 0; i < points.size(); i++) {
      within &= points.x(i) >= 0 && points.x(i) < area.width();
      within &= points.y(i) >= 0 && points.y(i) < area.height();
    }
    return within;
  }
}
