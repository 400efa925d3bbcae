package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;
import java.util.Locale;

/**
 * Random sites that are drawn one after the other, again where a place is taken or outside the
 * area: in a disk, in clusters, on a circle, on lines.
 */
final class ScatteredSites {
  private static final int PATIENCE = 100_000; // draws in vain, one after the other
  private static final int STEEPEST = 3;

  private final Grid grid;
  private final SeededRandom random;
  private final double centreX;
  private final double centreY;
  private final double radius; // of the largest disk

  private ScatteredSites(Area area, SeededRandom random) {
    this.grid = area.grid();
    this.random = random;
    centreX = grid.columns() / 2.0;
    centreY = grid.rows() / 2.0;
    radius = Math.min(centreX, centreY);
  }

  /** Draws a place, as coordinates that are rounded down. */
  @FunctionalInterface
  private interface Draw {
    double[] next();
  }

  /** Sites that are uniform in the largest disk. */
  static Points disk(int n, Area area, SeededRandom random, Progress progress) {
    ScatteredSites sites = new ScatteredSites(area, random);
    return sites.different(n, area, progress, sites::inDisk);
  }

  /** Sites near the largest circle. */
  static Points circle(int n, Area area, SeededRandom random, Progress progress) {
    ScatteredSites sites = new ScatteredSites(area, random);
    return sites.different(n, area, progress, sites::onCircle);
  }

  /**
   * Sites in about √n / 3 clusters, each normally distributed about a random centre; the standard
   * deviation is that of neighbouring clusters that just touch.
   */
  static Points clusters(int n, Area area, SeededRandom random, Progress progress) {
    ScatteredSites sites = new ScatteredSites(area, random);
    double[][] centres = new double[1 + (int) Math.sqrt(n / 9.0)][];
    for (int i = 0; i < centres.length; i++) {
      centres[i] = sites.anywhere();
    }
    double deviation = sites.radius / (4 * Math.sqrt(centres.length));
    return sites.different(n, area, progress, () -> sites.near(centres, deviation));
  }

  /** Sites on about √n / 2 lines of small slopes, each line exactly straight. */
  static Points lines(int n, Area area, SeededRandom random, Progress progress) {
    ScatteredSites sites = new ScatteredSites(area, random);
    long[][] lines = new long[2 + (int) Math.sqrt(n / 4.0)][];
    for (int i = 0; i < lines.length; i++) {
      lines[i] = sites.line();
    }
    return sites.different(n, area, progress, () -> sites.on(lines));
  }

  private Points different(int n, Area area, Progress progress, Draw draw) {
    PlaceSet taken = new PlaceSet(grid, n);
    long[] x = new long[n];
    long[] y = new long[n];
    int vain = 0;
    for (int i = 0; i < n; ) {
      double[] at = draw.next();
      x[i] = (long) Math.floor(at[0]);
      y[i] = (long) Math.floor(at[1]);
      if (isInside(x[i], y[i]) && taken.add(x[i], y[i])) {
        i++;
        vain = 0;
      } else if (++vain == PATIENCE) {
        throw new CannotGenerateException(
            String.format(
                Locale.ROOT,
                "no %d different sites of this shape were found in %s; take a larger area or fewer",
                n,
                area));
      }
      if (i % 1024 == 0) {
        progress.checkCancelled();
      }
    }
    return grid.points(x, y);
  }

  private boolean isInside(long x, long y) {
    return x >= 0 && y >= 0 && x < grid.columns() && y < grid.rows();
  }

  private double[] anywhere() {
    return new double[] {random.nextDouble() * grid.columns(), random.nextDouble() * grid.rows()};
  }

  private double[] inDisk() {
    double u;
    double v;
    do {
      u = 2 * random.nextDouble() - 1;
      v = 2 * random.nextDouble() - 1;
    } while (u * u + v * v > 1);
    return new double[] {centreX + u * radius, centreY + v * radius};
  }

  private double[] onCircle() {
    double angle = 2 * Math.PI * random.nextDouble();
    return new double[] {
      centreX + radius * StrictMath.cos(angle), centreY + radius * StrictMath.sin(angle)
    };
  }

  /** Normally distributed about one of the centres; the polar method of G. Marsaglia. */
  private double[] near(double[][] centres, double deviation) {
    double[] centre = centres[random.nextInt(centres.length)];
    double u;
    double v;
    double square;
    do {
      u = 2 * random.nextDouble() - 1;
      v = 2 * random.nextDouble() - 1;
      square = u * u + v * v;
    } while (square >= 1 || square == 0);
    double scale = deviation * Math.sqrt(-2 * StrictMath.log(square) / square);
    return new double[] {centre[0] + u * scale, centre[1] + v * scale};
  }

  /** A place, and a step from there to the next on its line. */
  private long[] line() {
    int dx;
    int dy;
    do {
      dx = random.nextInt(2 * STEEPEST + 1) - STEEPEST;
      dy = random.nextInt(2 * STEEPEST + 1) - STEEPEST;
    } while (dx == 0 && dy == 0);
    return new long[] {random.nextLong(grid.columns()), random.nextLong(grid.rows()), dx, dy};
  }

  private double[] on(long[][] lines) {
    long[] line = lines[random.nextInt(lines.length)];
    long longest = Math.max(grid.columns(), grid.rows());
    long step = random.nextLong(2 * longest + 1) - longest;
    return new double[] {line[0] + step * line[2], line[1] + step * line[3]};
  }
}
