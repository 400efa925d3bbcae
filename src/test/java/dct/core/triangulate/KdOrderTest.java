package dct.core.triangulate;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.Random;
import java.util.function.DoubleSupplier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Every cut of the tree separates, whatever the box and however the sites lie in it. */
class KdOrderTest {

  /** Where coordinates come from. */
  enum Spread {
    UNIFORM,
    FEW_VALUES,
    CLUSTERS,
    EVERY_SCALE,
    ONE_VALUE,
    WIDER_THAN_THE_LARGEST_DOUBLE,
    DENORMAL;

    private double next(Random r) {
      return switch (this) {
        case UNIFORM -> r.nextDouble();
        case FEW_VALUES -> r.nextInt(20);
        case CLUSTERS -> r.nextInt(3) + 1e-6 * r.nextGaussian();
        case EVERY_SCALE -> Math.scalb(r.nextDouble() - 0.5, -r.nextInt(1000));
        case ONE_VALUE -> 7;
        case WIDER_THAN_THE_LARGEST_DOUBLE -> (2 * r.nextDouble() - 1) * Double.MAX_VALUE;
        case DENORMAL -> r.nextInt(50) * Double.MIN_VALUE;
      };
    }

    DoubleSupplier from(Random random) {
      return () -> next(random);
    }
  }

  @ParameterizedTest
  @EnumSource
  void allBeforeACutPrecedeAllAfterIt(Spread spread) {
    for (Spread other : Spread.values()) {
      for (int n : new int[] {2, 11, 12, 13, 300, 5000}) {
        Random random = new Random(n);
        double[] x = coordinates(n, spread.from(random));
        double[] y = coordinates(n, other.from(random));
        KdOrder order = new KdOrder(Points.of(x, y), Progress.NONE);
        Walk walk = new Walk(order);
        walk.visit(0, n, true, KdOrder.ROOT);
        assertThat(Arrays.stream(order.site).sorted().toArray()).isEqualTo(range(n));
        for (int place = 0; place < n; place++) {
          assertThat(order.x[place]).isEqualTo(x[order.site[place]]);
          assertThat(order.y[place]).isEqualTo(y[order.site[place]]);
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1_000, 20_000, 300_000})
  void uniformSitesAreCutAlongCellsAlmostToTheLeaves(int n) {
    Random random = new Random(5);
    double[] x = coordinates(n, random::nextDouble);
    double[] y = coordinates(n, random::nextDouble);
    Walk walk = new Walk(new KdOrder(Points.of(x, y), Progress.NONE));
    walk.visit(0, n, true, KdOrder.ROOT);
    assertThat(walk.largestMedian).isLessThan(60);
  }

  /** With medians of three alone the looks are quadratic: hundreds for each of so few sites. */
  @ParameterizedTest
  @ValueSource(ints = {100, 1_000, 6_000})
  void anOrderMadeAgainstMediansOfThreeIsCutInLinearTime(int n) {
    KdOrder killer = new KdOrder(inOneCell(new MedianOfThreeKiller(n).values()), Progress.NONE);
    assertThat(killer.select(0, n - 1, n / 2, true)).isLessThanOrEqualTo(60L * n);
    for (int place = 0; place < n; place++) {
      assertThat(killer.precedes(n / 2, place, true)).isEqualTo(place > n / 2);
    }
  }

  @Test
  void ordinaryOrdersAreCutByMediansOfThree() {
    int n = 100_000;
    double[] x = coordinates(n, new Random(1)::nextDouble);
    assertThat(new KdOrder(inOneCell(x), Progress.NONE).select(0, n - 1, n / 2, true))
        .isLessThan(6L * n);
    Arrays.sort(x);
    assertThat(new KdOrder(inOneCell(x), Progress.NONE).select(0, n - 1, n / 2, true))
        .isLessThan(2L * n);
  }

  /**
   * Sites on a line in this order, and one so far away that all others share a cell of the grid.
   */
  private static Points inOneCell(double[] values) {
    double[] x = Arrays.copyOf(values, values.length + 1);
    x[values.length] = 1e18;
    return Points.of(x, x.clone());
  }

  /**
   * Makes an order for which the median of three of first, middle and last is as bad as it can be:
   * values are fixed only when two open ones are compared, the lowest first (M. D. McIlroy, <i>A
   * Killer Adversary for Quicksort</i>, 1999).
   */
  private static final class MedianOfThreeKiller {
    private static final int OPEN = Integer.MAX_VALUE;

    private final int[] value; // by first place
    private final int[] at; // by place now: the first place of what is there
    private int fixed;
    private int candidate;

    MedianOfThreeKiller(int n) {
      value = new int[n];
      Arrays.fill(value, OPEN);
      at = range(n);
      select(n / 2);
    }

    double[] values() {
      return Arrays.stream(value).mapToDouble(v -> v == OPEN ? fixed++ : v).toArray();
    }

    private boolean precedes(int a, int b) {
      if (value[a] == OPEN && value[b] == OPEN) {
        value[a == candidate ? a : b] = fixed++;
      }
      candidate = value[a] == OPEN ? a : value[b] == OPEN ? b : candidate;
      return value[a] < value[b];
    }

    private void select(int place) {
      int lo = 0;
      int hi = at.length - 1;
      while (lo < hi) {
        int pivot = at[median(lo, (lo + hi) >>> 1, hi)];
        int i = lo;
        int j = hi;
        while (i <= j) {
          while (precedes(at[i], pivot)) {
            i++;
          }
          while (precedes(pivot, at[j])) {
            j--;
          }
          if (i <= j) {
            int swap = at[i];
            at[i++] = at[j];
            at[j--] = swap;
          }
        }
        hi = place <= j ? j : hi;
        lo = place >= i ? i : lo;
        if (place > j && place < i) {
          return;
        }
      }
    }

    private int median(int a, int b, int c) {
      if (precedes(at[a], at[b])) {
        return precedes(at[b], at[c]) ? b : precedes(at[a], at[c]) ? c : a;
      }
      return precedes(at[a], at[c]) ? a : precedes(at[b], at[c]) ? c : b;
    }
  }

  private static double[] coordinates(int n, DoubleSupplier next) {
    double[] values = new double[n];
    Arrays.setAll(values, i -> next.getAsDouble());
    return values;
  }

  private static int[] range(int n) {
    return IntStream.range(0, n).toArray();
  }

  /** Visits the parts as the triangulation does. */
  private static final class Walk {
    private final KdOrder order;
    private int largestMedian; // the largest part that was cut at its median

    Walk(KdOrder order) {
      this.order = order;
    }

    void visit(int lo, int hi, boolean byX, int node) {
      if (hi - lo <= KdOrder.LEAF) {
        return;
      }
      int cut = order.cellCut(node);
      boolean alongCells = cut != Dcel.NONE;
      int middle = alongCells ? cut : order.cutAtMedian(lo, hi, byX);
      if (!alongCells) {
        largestMedian = Math.max(largestMedian, hi - lo);
      }
      assertThat(middle).isBetween(lo, hi);
      assertSeparated(lo, middle, hi, byX);
      visit(lo, middle, !byX, alongCells ? 2 * node : KdOrder.MEDIANS);
      visit(middle, hi, !byX, alongCells ? 2 * node + 1 : KdOrder.MEDIANS);
    }

    private void assertSeparated(int lo, int middle, int hi, boolean byX) {
      if (lo == middle || middle == hi) {
        return;
      }
      int last = lo;
      for (int place = lo; place < middle; place++) {
        last = order.precedes(last, place, byX) ? place : last;
      }
      for (int place = middle; place < hi; place++) {
        assertThat(order.precedes(place, last, byX)).isFalse();
      }
    }
  }
}
