package dct.testing;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.experiment.generate.Area;
import dct.experiment.generate.PolygonShape;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Random;

/**
 * Seeded simple polygons of many families. Every family is exact: its coordinates are whole numbers
 * (or doubles that are compared exactly), so that what it gives is simple by construction or was
 * checked by {@link SimplicityOracle}.
 */
public final class RandomPolygons {

  /** A named way to make a polygon of about n vertices from a seed. */
  public record Family(String name, Maker maker) {
    /** The polygon; the same for the same n and seed. */
    public Points make(int n, long seed) {
      return maker.make(n, new Random(seed));
    }

    @Override
    public String toString() {
      return name;
    }
  }

  /** Makes a polygon of about n vertices. */
  @FunctionalInterface
  public interface Maker {
    /** At least three vertices. */
    Points make(int n, Random random);
  }

  private RandomPolygons() {}

  /** All families that stay quick to make and to check up to a few hundred vertices. */
  public static List<Family> families() {
    return List.of(
        new Family("star-shaped", RandomPolygons::starShaped),
        new Family("x-monotone", RandomPolygons::xMonotone),
        new Family("y-monotone", (n, r) -> Transforms.rotated(xMonotone(n, r), 1)),
        new Family("grown", (n, r) -> GrownPolygon.grow(n, 10 * n, r)),
        new Family("grown on a small grid", (n, r) -> GrownPolygon.grow(n, gridFor(n), r)),
        new Family("untangled", (n, r) -> untangled(n, 1000, r)),
        new Family("untangled on a full grid", (n, r) -> untangled(n, 1 + side(n), r)),
        new Family("cells", (n, r) -> Polyomino.grow(n / 2 + 1, r).outline(false)),
        new Family("cells, every grid point", (n, r) -> Polyomino.grow(n / 2, r).outline(true)),
        new Family("maze", (n, r) -> Polyomino.maze(n / 4 + 2, r).outline(r.nextBoolean())),
        new Family("comb", RandomPolygons::comb),
        new Family("spiral", RandomPolygons::spiral),
        new Family("ulps", (n, r) -> Transforms.ulps(GrownPolygon.grow(n, gridFor(n), r))),
        new Family("wide range of exponents", RandomPolygons::wideRange),
        new Family("convex", RandomPolygons::convex),
        new Family("convex with straight vertices", RandomPolygons::convexWithStraightVertices));
  }

  private static int side(int n) {
    return (int) Math.sqrt(n);
  }

  private static Points untangled(int n, int side, Random random) {
    Area area = new Area(side, side, true);
    return PolygonShape.TWO_OPT.generate(n, area, random.nextLong(), Progress.NONE).points();
  }

  private static int gridFor(int n) {
    return 2 + (int) Math.sqrt(2.0 * n);
  }

  /** Lattice points in different directions from the origin, in angular order about it. */
  public static Points starShaped(int n, Random random) {
    int range = 20 + 5 * n;
    long[][] rays = new long[n][];
    do {
      Arrays.setAll(rays, i -> ray(random, range));
      Arrays.sort(rays, RandomPolygons::compareAngle);
    } while (!windsOnce(rays));
    return points(rays);
  }

  private static long[] ray(Random random, int range) {
    long x = (long) random.nextInt(2 * range + 1) - range;
    long y = (long) random.nextInt(2 * range + 1) - range;
    return x == 0 && y == 0 ? ray(random, range) : new long[] {x, y};
  }

  private static int compareAngle(long[] a, long[] b) {
    int half = Boolean.compare(isLower(a), isLower(b));
    return half != 0 ? half : -Long.signum(cross(a, b));
  }

  private static boolean isLower(long[] v) {
    return v[1] < 0 || (v[1] == 0 && v[0] < 0);
  }

  private static long cross(long[] a, long[] b) {
    return a[0] * b[1] - a[1] * b[0];
  }

  private static boolean windsOnce(long[][] rays) {
    for (int i = 0; i < rays.length; i++) {
      if (cross(rays[i], rays[(i + 1) % rays.length]) <= 0) {
        return false;
      }
    }
    return true;
  }

  /** Two chains between the leftmost and the rightmost point, in the order by x, then y. */
  public static Points xMonotone(int n, Random random) {
    int range = random.nextBoolean() ? n / 2 + 3 : 100 * n;
    Points chain = twoChains(points(distinct(n, range, random)));
    return chain.size() < 3 ? xMonotone(n + 1, random) : chain;
  }

  /** The same with coordinates from 10⁻³⁰⁰ to 10³⁰⁰ and zero. */
  public static Points wideRange(int n, Random random) {
    double[] x = random.doubles(n).map(u -> wide(u, random)).toArray();
    double[] y = random.doubles(n).map(u -> wide(u, random)).toArray();
    Points chain = twoChains(Sites.of(Points.of(x, y), Progress.NONE).points());
    boolean turned = random.nextBoolean();
    return chain.size() < 3
        ? wideRange(n + 1, random)
        : turned ? Transforms.rotated(chain, 1) : chain;
  }

  private static double wide(double u, Random random) {
    return random.nextInt(5) == 0 ? 0 : (u - 0.5) * StrictMath.pow(10, random.nextInt(613) - 305);
  }

  /** The points, without those on the line from the first to the last, as a simple polygon. */
  private static Points twoChains(Points pool) {
    int n = pool.size();
    Integer[] order = new Integer[n];
    Arrays.setAll(order, i -> i);
    Arrays.sort(order, Comparator.<Integer>comparingDouble(pool::x).thenComparingDouble(pool::y));
    int[] ring = new int[n];
    int size = 0;
    int first = order[0];
    int last = order[n - 1];
    ring[size++] = first;
    for (int k = 1; k < n - 1; k++) {
      if (Exact.orient(pool, first, last, order[k]) < 0) {
        ring[size++] = order[k];
      }
    }
    ring[size++] = last;
    for (int k = n - 2; k > 0; k--) {
      if (Exact.orient(pool, first, last, order[k]) > 0) {
        ring[size++] = order[k];
      }
    }
    return select(pool, Arrays.copyOf(ring, size));
  }

  static long[][] distinct(int n, int range, Random random) {
    LinkedHashSet<List<Long>> set = new LinkedHashSet<>();
    while (set.size() < n) {
      set.add(List.of((long) random.nextInt(range), (long) random.nextInt(range)));
    }
    return set.stream().map(p -> new long[] {p.get(0), p.get(1)}).toArray(long[][]::new);
  }

  /** Teeth of random or equal length on a back. */
  public static Points comb(int n, Random random) {
    int teeth = Math.max(1, n / 2 - 1);
    boolean equal = random.nextBoolean();
    long[][] p = new long[2 * teeth + 3][];
    int k = 0;
    p[k++] = new long[] {2L * teeth + 2, -1};
    for (int tooth = teeth; tooth > 0; tooth--) {
      p[k++] = new long[] {2L * tooth + 1, 100};
      p[k++] = new long[] {2L * tooth, equal ? 0 : random.nextInt(90)};
    }
    p[k++] = new long[] {1, 100};
    p[k] = new long[] {0, -1};
    return points(p);
  }

  /** A corridor of constant width wound up, with corners at grid points. */
  public static Points spiral(int n, Random random) {
    int turns = Math.max(2, n / 2 - 1);
    int width = 1 + random.nextInt(3);
    int gap = 1 + random.nextInt(3);
    long[][] outer = spiralArm(turns, width + gap, 0);
    long[][] inner = spiralArm(turns, width + gap, width);
    long[][] p = new long[2 * outer.length][];
    for (int i = 0; i < outer.length; i++) {
      p[i] = outer[i];
      p[p.length - 1 - i] = inner[i];
    }
    return points(p);
  }

  /** The corners of a square spiral from the inside out, moved by {@code shift} to its left. */
  private static long[][] spiralArm(int turns, int pitch, int shift) {
    int[] dx = {1, 0, -1, 0};
    int[] dy = {0, 1, 0, -1};
    long[][] arm = new long[turns + 1][];
    long x = 0;
    long y = 0;
    for (int i = 0; i <= turns; i++) {
      int in = (i + 3) % 4; // direction before this corner
      int out = i % 4;
      int sx = (i == 0 ? 0 : -dy[in]) + (i == turns ? 0 : -dy[out]);
      int sy = (i == 0 ? 0 : dx[in]) + (i == turns ? 0 : dx[out]);
      arm[i] = new long[] {x + (long) shift * sx, y + (long) shift * sy};
      long length = (long) pitch * (i / 2 + 1) + 2L * pitch;
      x += length * dx[out];
      y += length * dy[out];
    }
    return arm;
  }

  /** Lattice points in convex position, without straight vertices. */
  public static Points convex(int n, Random random) {
    return convexSides(n, random, false);
  }

  /** A convex region whose sides may hold further vertices. */
  public static Points convexWithStraightVertices(int n, Random random) {
    return convexSides(n, random, true);
  }

  /** Random side vectors that sum to zero, in angular order: Minkowski's way. */
  private static Points convexSides(int n, Random random, boolean straight) {
    while (true) {
      long[][] sides = closedSides(n, random, straight ? 3 : 1000 * n);
      Arrays.sort(sides, RandomPolygons::compareAngle);
      if (isStrict(sides) || (straight && !isFlat(sides))) {
        return points(summed(sides));
      }
    }
  }

  private static long[][] closedSides(int n, Random random, int range) {
    long[][] sides = new long[n][];
    Arrays.setAll(sides, i -> ray(random, range));
    long x = 0;
    long y = 0;
    for (int i = 0; i < n - 1; i++) {
      x += sides[i][0];
      y += sides[i][1];
    }
    sides[n - 1] = new long[] {-x, -y};
    return x == 0 && y == 0 ? closedSides(n, random, range) : sides;
  }

  private static boolean isStrict(long[][] sides) {
    return windsOnce(sides);
  }

  private static boolean isFlat(long[][] sides) {
    for (long[] side : sides) {
      if (cross(sides[0], side) != 0) {
        return false;
      }
    }
    return true;
  }

  private static long[][] summed(long[][] sides) {
    long[][] corners = new long[sides.length][];
    long x = 0;
    long y = 0;
    for (int i = 0; i < sides.length; i++) {
      corners[i] = new long[] {x, y};
      x += sides[i][0];
      y += sides[i][1];
    }
    return corners;
  }

  static Points select(Points pool, int[] ring) {
    double[] x = new double[ring.length];
    double[] y = new double[ring.length];
    for (int k = 0; k < ring.length; k++) {
      x[k] = pool.x(ring[k]);
      y[k] = pool.y(ring[k]);
    }
    return Points.of(x, y);
  }

  static Points points(long[][] pairs) {
    double[] x = new double[pairs.length];
    double[] y = new double[pairs.length];
    for (int i = 0; i < pairs.length; i++) {
      x[i] = pairs[i][0];
      y[i] = pairs[i][1];
    }
    return Points.of(x, y);
  }
}
