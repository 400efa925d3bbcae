package dct.bench;

import dct.bench.Contest.Outcome;

/**
 * Which contenders sit out as inputs grow tenfold: those that would take too long, going by how
 * their time grew so far, and those that went wrong already.
 */
final class Pace {
  private static final double LONGEST = 8_000; // milliseconds
  private static final double LEAST_GROWTH = 10;

  private final double[] before;
  private final String[] remark;

  Pace(int contenders) {
    before = new double[contenders];
    remark = new String[contenders];
  }

  /** By contender, why it sits out, or null. */
  String[] sittingOut() {
    return remark.clone();
  }

  /** Takes note of the outcomes for the present size. */
  void note(Outcome[] outcomes) {
    for (int c = 0; c < outcomes.length; c++) {
      double millis = outcomes[c].millis();
      if (outcomes[c].isTimed()) {
        double growth = before[c] == 0 ? LEAST_GROWTH : millis / before[c];
        remark[c] = millis * Math.max(LEAST_GROWTH, growth) > LONGEST ? "over 8 s" : null;
        before[c] = millis;
      } else if (remark[c] == null) {
        remark[c] = outcomes[c].remark().replaceFirst(":.*", " before");
      }
    }
  }
}
