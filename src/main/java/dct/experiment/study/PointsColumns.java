package dct.experiment.study;

import java.util.List;

/** The names of the numbers that the study of sites counts, and what follows from a row of them. */
final class PointsColumns {
  static final String HULL = "hull";
  static final String BEFORE = "even_before";
  static final String AFTER = "even_after";
  static final String FLIPS = "flips";
  static final String REPEATED = "even_repeated";
  static final String REPEATED_FLIPS = "repeated_flips";
  static final String SCANS = "scans";

  /** All of them, in the order of the columns. */
  static final List<String> ALL =
      List.of(
          HULL,
          BEFORE,
          AFTER,
          FLIPS,
          REPEATED,
          REPEATED_FLIPS,
          SCANS,
          StudyRow.BEST,
          StudyRow.LIMIT);

  private PointsColumns() {}

  /** By how much Scan-Flip increased the even vertices, in per cent. */
  static double increase(StudyRow row) {
    int before = row.count(BEFORE);
    return 100.0 * (row.count(AFTER) - before) / before;
  }
}
