package dct.core.degree.bound;

import dct.core.degree.ParityGoal;
import dct.core.degree.colour.HullRing;
import dct.core.geometry.Points;
import dct.testing.RandomSets;
import dct.testing.RandomSets.Family;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Seeded small sets of sites that are hard to make even, beside those that tests share. */
public final class SmallSets {

  private SmallSets() {}

  /** All families: the shared ones and those of this class. */
  public static List<Family> families() {
    List<Family> families = new ArrayList<>(RandomSets.families());
    families.add(new Family("run on one side", (n, r) -> run(n, 1 + r.nextInt(4), r)));
    families.add(new Family("runs on three sides", SmallSets::runsOnTriangle));
    families.add(new Family("triangle with sites inside", SmallSets::triangle));
    families.add(new Family("lattice with a site missing", SmallSets::nearLattice));
    families.add(new Family("sheared lattice", SmallSets::shearedLattice));
    families.add(new Family("lattice triangle", (n, r) -> latticeTriangle(2 + r.nextInt(2), r)));
    families.add(new Family("convex", (n, r) -> convex(n, 0, r)));
    families.add(new Family("convex with a site inside", (n, r) -> convex(n - 1, 1, r)));
    families.add(new Family("convex with two sites inside", (n, r) -> convex(n - 2, 2, r)));
    return families;
  }

  private static Points points(List<double[]> list) {
    double[] x = list.stream().mapToDouble(p -> p[0]).toArray();
    double[] y = list.stream().mapToDouble(p -> p[1]).toArray();
    return Points.of(x, y);
  }

  private static double[] xy(double x, double y) {
    return new double[] {x, y};
  }

  private static Points run(int n, int off, Random random) {
    List<double[]> list = new ArrayList<>();
    for (int i = 0; i < n - off; i++) {
      list.add(xy(10 * i, 0));
    }
    for (int i = 0; i < Math.min(off, n); i++) {
      list.add(xy(random.nextInt(10 * n), 1 + random.nextInt(60)));
    }
    return points(list);
  }

  private static Points runsOnTriangle(int n, Random random) {
    List<double[]> list = new ArrayList<>(List.of(xy(0, 0), xy(12, 0), xy(0, 12)));
    while (list.size() < n) {
      int t = 1 + random.nextInt(11);
      switch (random.nextInt(4)) {
        case 0 -> list.add(xy(t, 0));
        case 1 -> list.add(xy(0, t));
        case 2 -> list.add(xy(t, 12 - t));
        default -> list.add(xy(1 + random.nextInt(5), 1 + random.nextInt(5)));
      }
    }
    return points(list);
  }

  private static Points triangle(int n, Random random) {
    List<double[]> list = new ArrayList<>(List.of(xy(0, 0), xy(3000, 0), xy(1000, 2700)));
    while (list.size() < n) {
      double a = random.nextDouble();
      double b = random.nextDouble() * (1 - a);
      list.add(xy(Math.rint(3000 * a + 1000 * b), Math.rint(2700 * b)));
    }
    return points(list);
  }

  private static Points nearLattice(int n, Random random) {
    Points lattice = lattice(n + 1, 2 + random.nextInt(3), 0);
    return lattice.removed(random.nextInt(lattice.size()));
  }

  private static Points shearedLattice(int n, Random random) {
    return lattice(n, 2 + random.nextInt(3), random.nextInt(4));
  }

  private static Points lattice(int n, int width, int shear) {
    List<double[]> list = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      int row = Math.floorDiv(i, width);
      list.add(xy(0.75 * (i % width) + shear * row, 3 * row - 0.25 * shear * (i % width)));
    }
    return points(list);
  }

  private static Points latticeTriangle(int side, Random random) {
    int shear = random.nextInt(3);
    List<double[]> list = new ArrayList<>();
    for (int i = 0; i <= side; i++) {
      for (int j = 0; i + j <= side; j++) {
        list.add(xy(5 * i + shear * j, 5 * j));
      }
    }
    return points(list);
  }

  private static Points convex(int n, int inside, Random random) {
    List<double[]> list = new ArrayList<>();
    for (int i = 0; i < Math.max(3, n); i++) {
      double angle = 2 * Math.PI * random.nextDouble();
      list.add(xy(Math.rint(1e6 * StrictMath.cos(angle)), Math.rint(1e6 * StrictMath.sin(angle))));
    }
    for (int i = 0; i < inside; i++) {
      list.add(xy(random.nextInt(400_000) - 200_000, random.nextInt(400_000) - 200_000));
    }
    return points(list);
  }

  /** A goal with any wish for each of n vertices. */
  public static ParityGoal randomGoal(int n, Random random) {
    ParityGoal.Wish[] wishes = new ParityGoal.Wish[n];
    boolean someFree = random.nextBoolean();
    int oddInTen = 1 + random.nextInt(9);
    for (int v = 0; v < n; v++) {
      ParityGoal.Wish definite =
          random.nextInt(10) < oddInTen ? ParityGoal.Wish.ODD : ParityGoal.Wish.EVEN;
      wishes[v] = someFree && random.nextInt(3) == 0 ? ParityGoal.Wish.ANY : definite;
    }
    return ParityGoal.of(wishes);
  }

  /** Even inside the hull and any definite wish on it: the goals to which most bounds apply. */
  static ParityGoal randomHullGoal(HullRing ring, Random random) {
    ParityGoal.Wish[] wishes = new ParityGoal.Wish[ring.points().size()];
    boolean someFree = random.nextInt(3) == 0;
    for (int v = 0; v < wishes.length; v++) {
      boolean odd = ring.contains(v) && random.nextInt(3) == 0;
      boolean free = ring.contains(v) && someFree && random.nextInt(3) == 0;
      ParityGoal.Wish definite = odd ? ParityGoal.Wish.ODD : ParityGoal.Wish.EVEN;
      wishes[v] = free ? ParityGoal.Wish.ANY : definite;
    }
    return ParityGoal.of(wishes);
  }

  /** Sites on both axes, so many on each half of one, and the origin: x0, y0, x1, y1, …. */
  public static double[] cross(int level, int upright) {
    double[] pairs = new double[4 * (level + upright) + 2];
    for (int i = 0; i < level; i++) {
      pairs[4 * i] = i + 1;
      pairs[4 * i + 2] = -i - 1;
    }
    for (int i = level; i < level + upright; i++) {
      pairs[4 * i + 1] = i - level + 1;
      pairs[4 * i + 3] = level - i - 1;
    }
    return pairs;
  }

  /** So many sites on each side of a triangle and five in it: x0, y0, x1, y1, …. */
  public static double[] sidesOfTriangle(int onSide) {
    double[] inside = {2, 3, 3, 2, 3, 4, 4, 1, 1, 6};
    double[] pairs = new double[6 * onSide + inside.length];
    for (int i = 0; i < onSide; i++) {
      double[] onSides = {i, 0, onSide - i, i, 0, onSide - i};
      System.arraycopy(onSides, 0, pairs, 6 * i, 6);
    }
    for (int i = 0; i < inside.length; i++) {
      pairs[6 * onSide + i] = inside[i] * onSide / 10;
    }
    return pairs;
  }
}
