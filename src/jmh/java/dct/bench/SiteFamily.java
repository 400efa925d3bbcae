package dct.bench;

import java.util.List;
import java.util.Random;
import java.util.function.Function;

/**
 * The sites of the comparison: named distributions, and sets that break floating point.
 *
 * @param title as the tables call it
 * @param isNasty whether it is a set that breaks floating point, with a size of its own
 * @param maker makes the sites
 */
record SiteFamily(String title, boolean isNasty, Maker maker) {
  private static final double ULP = 0x1p-52; // at 1

  /** In the unit square. */
  static final SiteFamily UNIFORM =
      plain("uniform", (n, r) -> each(n, i -> xy(r.nextDouble(), r.nextDouble())));

  /** All of them. */
  static List<SiteFamily> all() {
    return List.of(
        UNIFORM,
        plain("clusters", SiteFamily::clusters),
        plain("lattice", (n, r) -> lattice((int) Math.round(Math.sqrt(n)), r)),
        plain("circle", (n, r) -> each(n, i -> onCircle(1, r.nextDouble()))),
        plain("integer pixels", SiteFamily::pixels),
        nasty("turned lattice", r -> turnedLattice(150)),
        nasty("far lattice", r -> farLattice(150)),
        nasty("near a line", r -> nearLine(16_001, r)),
        nasty("box of ulps", r -> boxOfUlps(4_000, r)),
        nasty("two tiny circles", r -> twoCircles(4_000, r)),
        nasty("shrinking radii", r -> shrinking(4_000, r)),
        nasty("all collinear", r -> each(5_000, i -> xy(3 * i, 7 * i))),
        nasty("each twice", r -> twice(5_000, r)));
  }

  /** The one with this title. */
  static SiteFamily of(String title) {
    return all().stream().filter(f -> f.title().equals(title)).findFirst().orElseThrow();
  }

  /** Coordinates, [0] being x and [1] y. */
  @FunctionalInterface
  interface Maker {
    double[][] make(int n, Random random);
  }

  @FunctionalInterface
  private interface Place {
    double[] at(int i);
  }

  private static SiteFamily plain(String title, Maker maker) {
    return new SiteFamily(title, false, maker);
  }

  private static SiteFamily nasty(String title, Function<Random, double[][]> maker) {
    return new SiteFamily(title, true, (n, random) -> maker.apply(random));
  }

  /** About n sites; the nasty sets have sizes of their own. */
  double[][] make(int n) {
    return maker.make(n, new Random(n));
  }

  private static double[] xy(double x, double y) {
    return new double[] {x, y};
  }

  private static double[][] each(int n, Place place) {
    double[][] points = new double[2][n];
    for (int i = 0; i < n; i++) {
      double[] at = place.at(i);
      points[0][i] = at[0];
      points[1][i] = at[1];
    }
    return points;
  }

  private static double[] onCircle(double radius, double turn) {
    double angle = 2 * Math.PI * turn;
    return xy(radius * Math.cos(angle), radius * Math.sin(angle));
  }

  private static double[][] clusters(int n, Random random) {
    int count = Math.max(1, n / 1000);
    double[][] centre = each(count, i -> xy(random.nextDouble(), random.nextDouble()));
    double spread = 0.1 / Math.sqrt(count);
    return each(
        n,
        i -> {
          int c = random.nextInt(count);
          return xy(
              centre[0][c] + spread * random.nextGaussian(),
              centre[1][c] + spread * random.nextGaussian());
        });
  }

  private static double[][] lattice(int side, Random random) {
    return shuffled(each(side * side, i -> xy(i % side, Math.floorDiv(i, side))), random);
  }

  private static double[][] pixels(int n, Random random) {
    int side = 2 * (int) Math.ceil(Math.sqrt(n));
    boolean[] taken = new boolean[side * side];
    return each(
        n,
        i -> {
          int place = random.nextInt(taken.length);
          while (taken[place]) {
            place = random.nextInt(taken.length);
          }
          taken[place] = true;
          return xy(place % side, Math.floorDiv(place, side));
        });
  }

  private static double[][] turnedLattice(int side) {
    double cos = Math.cos(0.3);
    double sin = Math.sin(0.3);
    return each(
        side * side,
        i -> {
          double column = i % side;
          double row = Math.floorDiv(i, side);
          return xy(column * cos - row * sin, column * sin + row * cos);
        });
  }

  private static double[][] farLattice(int side) {
    return each(
        side * side, i -> xy(1e6 + (i % side) * 0x1p-20, 1e6 + Math.floorDiv(i, side) * 0x1p-20));
  }

  private static double[][] nearLine(int n, Random random) {
    return each(n, i -> xy(1 + i / (double) n, 1 + i / (double) n + random.nextInt(5) * ULP));
  }

  private static double[][] boxOfUlps(int n, Random random) {
    boolean[] taken = new boolean[64 * 64];
    return each(
        n,
        i -> {
          int place = random.nextInt(taken.length);
          while (taken[place]) {
            place = random.nextInt(taken.length);
          }
          taken[place] = true;
          return xy(1 + (place & 63) * ULP, 1 + (place >> 6) * ULP);
        });
  }

  private static double[][] twoCircles(int n, Random random) {
    return each(
        n,
        i -> {
          double[] at = onCircle(1e-8, random.nextDouble());
          return xy(at[0] + (i & 1), at[1]);
        });
  }

  private static double[][] shrinking(int n, Random random) {
    return each(n, i -> onCircle(Math.pow(10, -12.0 * i / n), random.nextDouble()));
  }

  private static double[][] twice(int n, Random random) {
    double[][] once = each(n, i -> xy(random.nextDouble(), random.nextDouble()));
    return shuffled(each(2 * n, i -> xy(once[0][i % n], once[1][i % n])), random);
  }

  private static double[][] shuffled(double[][] points, Random random) {
    for (int i = points[0].length - 1; i > 0; i--) {
      int j = random.nextInt(i + 1);
      for (double[] axis : points) {
        double swapped = axis[i];
        axis[i] = axis[j];
        axis[j] = swapped;
      }
    }
    return points;
  }
}
