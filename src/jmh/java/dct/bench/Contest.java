package dct.bench;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Contenders on one input: each result is checked, then all are timed in turn, round after round,
 * so that whatever disturbs the machine disturbs all of them. The first contender is ours.
 */
final class Contest {
  private static final double ROUNDS_SECONDS = 2.5; // for all rounds of one input
  private static final int MOST_ROUNDS = 400;
  private static final int LEAST_ROUNDS = 5;
  private static final double LONG_ROUND = 0.1; // seconds; from here on each starts on a clean heap
  private static final int WARM_UP = 3; // runs at least
  private static final double WARM_UP_SECONDS = 1.5; // and at least so long
  private static final double SLOW_SECONDS = 1; // no warm-up beyond the check from here on

  /** Tells what is wrong with the result of the contender of this number, if anything. */
  @FunctionalInterface
  interface Check {
    Optional<String> problem(double[] x, double[] y, int contender, int[] result);
  }

  /**
   * What came of one contender.
   *
   * @param millis the median of its wall times; not a number if it was not timed
   * @param ratio the median over the rounds of our time over its time
   * @param remark why it was not timed, or what is wrong with its result
   */
  record Outcome(double millis, double ratio, String remark) {
    static Outcome none(String remark) {
      return new Outcome(Double.NaN, Double.NaN, remark);
    }

    boolean isTimed() {
      return !Double.isNaN(millis);
    }
  }

  private final double[] x;
  private final double[] y;
  private final List<Contender> contenders;
  private final Check check;
  private final Outcome[] outcomes;
  private final double[] firstSeconds;

  private Contest(double[] x, double[] y, List<Contender> contenders, Check check) {
    this.x = x;
    this.y = y;
    this.contenders = contenders;
    this.check = check;
    outcomes = new Outcome[contenders.size()];
    firstSeconds = new double[contenders.size()];
  }

  /** The outcomes in the order of the contenders; those with a remark in {@code sitOut} do. */
  static Outcome[] hold(
      double[] x, double[] y, List<Contender> contenders, Check check, String[] sitOut) {
    Contest contest = new Contest(x, y, contenders, check);
    contest.checkAll(sitOut);
    contest.time();
    return contest.outcomes;
  }

  private void checkAll(String[] sitOut) {
    for (int c = 0; c < outcomes.length; c++) {
      if (sitOut[c] != null) {
        outcomes[c] = Outcome.none(sitOut[c]);
        continue;
      }
      try {
        long start = System.nanoTime();
        int[] triangles = contenders.get(c).maker().triangles(x, y);
        firstSeconds[c] = (System.nanoTime() - start) * 1e-9;
        Optional<String> problem = check.problem(x, y, c, triangles);
        outcomes[c] = problem.map(p -> Outcome.none("wrong: " + p)).orElse(null);
      } catch (Exception | StackOverflowError | OutOfMemoryError failure) {
        outcomes[c] = Outcome.none("fails: " + failure.getClass().getSimpleName());
      }
    }
  }

  private void time() {
    List<Integer> timed = new ArrayList<>();
    double round = 0;
    for (int c = 0; c < outcomes.length; c++) {
      if (outcomes[c] == null) {
        timed.add(c);
        round += firstSeconds[c];
      }
    }
    for (int c : timed) {
      warmUp(c);
    }
    int rounds = (int) Math.max(LEAST_ROUNDS, Math.min(MOST_ROUNDS, ROUNDS_SECONDS / round));
    double[][] seconds = new double[outcomes.length][rounds];
    for (int r = 0; r < rounds; r++) {
      for (int c : timed) {
        if (round > LONG_ROUND) {
          System.gc(); // what one leaves behind is not to be collected in the time of the next
        }
        seconds[c][r] = seconds(c);
      }
    }
    for (int c : timed) {
      outcomes[c] = new Outcome(1e3 * median(seconds[c]), ratio(seconds[0], seconds[c]), null);
    }
  }

  /** Lets the compiler have its way with what is quick; what is slow has run for long enough. */
  private void warmUp(int c) {
    double spent = firstSeconds[c];
    for (int k = 0; (k < WARM_UP || spent < WARM_UP_SECONDS) && spent < SLOW_SECONDS; k++) {
      spent += seconds(c);
    }
  }

  private double seconds(int c) {
    try {
      long start = System.nanoTime();
      contenders.get(c).maker().triangles(x, y);
      return (System.nanoTime() - start) * 1e-9;
    } catch (Exception failure) {
      throw new IllegalStateException("what went well once fails", failure);
    }
  }

  private static double ratio(double[] ours, double[] theirs) {
    double[] ratios = new double[ours.length];
    Arrays.setAll(ratios, r -> ours[r] / theirs[r]);
    return median(ratios);
  }

  static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    int middle = sorted.length / 2;
    return sorted.length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
  }
}
