package dct.testing;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import java.util.List;
import java.util.Random;

/** Seeded sets of sites, from easy to nasty. */
public final class RandomSets {
  private static final double ULP = 0x1p-52; // at 1

  /** A named way to make about n sites from a seed. */
  public record Family(String name, Maker maker) {
    /** The sites; the same for the same n and seed. */
    public Sites make(int n, long seed) {
      return Sites.of(maker.make(n, new Random(seed)), Progress.NONE);
    }

    @Override
    public String toString() {
      return name;
    }
  }

  /** Makes about n points. */
  @FunctionalInterface
  public interface Maker {
    /** Duplicates are welcome. */
    Points make(int n, Random random);
  }

  private interface Point {
    double[] at(int i);
  }

  private RandomSets() {}

  /** All families. */
  public static List<Family> families() {
    return List.of(
        new Family("uniform", (n, r) -> of(n, i -> xy(r.nextDouble(), r.nextDouble()))),
        new Family("whole numbers", (n, r) -> of(n, i -> xy(r.nextInt(1000), r.nextInt(700)))),
        new Family("small grid", (n, r) -> grid(n, 2 + (int) Math.sqrt(n), r)),
        new Family("tiny grid", (n, r) -> grid(n, 4, r)),
        new Family("full lattice", RandomSets::fullLattice),
        new Family("lattice, rotated and rounded", (n, r) -> rotatedLattice(n)),
        new Family("fine lattice far away", (n, r) -> farLattice(n)),
        new Family("cocircular whole numbers", RandomSets::cocircular),
        new Family("circle, rounded", (n, r) -> circle(n, 1, 0)),
        new Family("circle and centre", (n, r) -> circle(n, 1, 1)),
        new Family("two tiny circles", (n, r) -> twoCircles(n)),
        new Family("shrinking radii", RandomSets::shrinkingRadii),
        new Family("within 2 ulps of a line", RandomSets::nearlyCollinear),
        new Family("box of ulps", (n, r) -> boxOfUlps(n, 2 + (int) Math.sqrt(n), r)),
        new Family("wide box of ulps", (n, r) -> boxOfUlps(n, 64, r)),
        new Family(
            "each twice", (n, r) -> twice(of(n / 2 + 1, i -> xy(r.nextInt(90), r.nextInt(90))))),
        new Family("all on a slanted line", RandomSets::collinear),
        new Family("all but one on a line", RandomSets::collinearButOne),
        new Family("two lines", RandomSets::twoLines),
        new Family("clusters", RandomSets::clusters),
        new Family("least and largest numbers", RandomSets::leastAndLargest),
        new Family("wide range of exponents", RandomSets::wideRange));
  }

  private static double[] xy(double x, double y) {
    return new double[] {x, y};
  }

  private static Points of(int n, Point point) {
    double[] x = new double[n];
    double[] y = new double[n];
    for (int i = 0; i < n; i++) {
      double[] at = point.at(i);
      x[i] = at[0];
      y[i] = at[1];
    }
    return Points.of(x, y);
  }

  private static Points grid(int n, int range, Random random) {
    return of(n, i -> xy(random.nextInt(range), random.nextInt(range)));
  }

  private static Points fullLattice(int n, Random random) {
    int width = 1 + random.nextInt(Math.max(1, (int) Math.sqrt(2.0 * n)));
    return of(n, i -> xy(i % width, Math.floorDiv(i, width)));
  }

  private static Points rotatedLattice(int n) {
    int side = side(n);
    double c = StrictMath.cos(0.5);
    double s = StrictMath.sin(0.5);
    return of(
        side * side,
        i ->
            xy(
                c * (i % side) - s * Math.floorDiv(i, side),
                s * (i % side) + c * Math.floorDiv(i, side)));
  }

  private static Points farLattice(int n) {
    int side = side(n);
    return of(
        side * side, i -> xy(1e6 + (i % side) * 0x1p-20, 1e6 + Math.floorDiv(i, side) * 0x1p-20));
  }

  private static int side(int n) {
    return Math.max(2, (int) Math.sqrt(n));
  }

  /** Whole points of the circle of radius 65 × 17 × 29 / 5 …, in random order with repetitions. */
  private static Points cocircular(int n, Random random) {
    int radius = 5 * 13 * 17; // the square is a sum of two squares in many ways
    return of(
        n,
        i -> {
          int y;
          int x;
          do {
            x = random.nextInt(2 * radius + 1) - radius;
            y = (int) Math.round(Math.sqrt((double) radius * radius - (double) x * x));
          } while (x * x + y * y != radius * radius);
          return xy(x, random.nextBoolean() ? y : -y);
        });
  }

  private static Points circle(int n, double radius, int centres) {
    return of(
        n + centres,
        i ->
            i == n
                ? xy(0, 0)
                : xy(
                    radius * StrictMath.cos(2 * Math.PI * i / n),
                    radius * StrictMath.sin(2 * Math.PI * i / n)));
  }

  private static Points twoCircles(int n) {
    int half = n / 2 + 2;
    return of(
        2 * half,
        i -> {
          double angle = 2 * Math.PI * (i % half) / half;
          return xy(
              1e-8 * StrictMath.cos(angle) + Math.floorDiv(i, half), 1e-8 * StrictMath.sin(angle));
        });
  }

  private static Points shrinkingRadii(int n, Random random) {
    return of(
        n,
        i -> {
          double radius = StrictMath.pow(10, -12.0 * i / n);
          double angle = 2 * Math.PI * random.nextDouble();
          return xy(radius * StrictMath.cos(angle), radius * StrictMath.sin(angle));
        });
  }

  private static Points nearlyCollinear(int n, Random random) {
    return of(
        n,
        i -> {
          double t = 1 + random.nextInt(Math.max(2, n)) / (double) n;
          return xy(t, t + (random.nextInt(5) - 2) * ULP);
        });
  }

  private static Points boxOfUlps(int n, int side, Random random) {
    return of(n, i -> xy(1 + random.nextInt(side) * ULP, 1 + random.nextInt(side) * ULP));
  }

  private static Points twice(Points points) {
    int n = points.size();
    return of(2 * n, i -> xy(points.x(i % n), points.y(i % n)));
  }

  private static Points collinear(int n, Random random) {
    return of(
        n,
        i -> {
          int t = random.nextInt(10 * n + 1);
          return xy(3 * t + 1, 7 - 2 * t);
        });
  }

  private static Points collinearButOne(int n, Random random) {
    Points line = collinear(n, random);
    return line.inserted(random.nextInt(n + 1), random.nextInt(n + 1), 8.25);
  }

  private static Points twoLines(int n, Random random) {
    return of(n, i -> xy(random.nextInt(2 * n), i % 2));
  }

  private static Points clusters(int n, Random random) {
    return of(
        n, i -> xy(i % 5 + 1e-3 * random.nextGaussian(), i % 3 + 1e-6 * random.nextGaussian()));
  }

  private static Points leastAndLargest(int n, Random random) {
    double[] values = {
      0,
      1,
      -1,
      Double.MIN_VALUE,
      -Double.MIN_VALUE,
      Double.MIN_NORMAL,
      1 + ULP,
      -2,
      0x1p-538,
      0x1p511,
      0x1p1023,
      Double.MAX_VALUE,
      -Double.MAX_VALUE,
      Math.nextDown(Double.MAX_VALUE)
    };
    return of(
        n, i -> xy(values[random.nextInt(values.length)], values[random.nextInt(values.length)]));
  }

  /** Coordinates from 10⁻³⁰⁰ to 10³⁰⁰: nothing but the slowest exact stage can decide these. */
  private static Points wideRange(int n, Random random) {
    return of(n, i -> xy(wide(random), wide(random)));
  }

  private static double wide(Random random) {
    return random.nextGaussian() * StrictMath.pow(10, random.nextInt(601) - 300);
  }
}
