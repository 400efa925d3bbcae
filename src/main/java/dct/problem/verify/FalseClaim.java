package dct.problem.verify;

/** Thrown at the first claim of a result file that is not true. */
public final class FalseClaim extends RuntimeException {
  /** What mends a false claim, behind its message. */
  public static final String CURE = "; make the result again from its input";

  private static final long serialVersionUID = 1L;
  private final int line;

  /** A false claim on this line of the file. */
  FalseClaim(int line, String message) {
    super(message, null, false, false);
    this.line = line;
  }

  /** A false claim in the summary, which stands on the first line. */
  FalseClaim(String message) {
    this(1, message);
  }

  /** The line of the file that the claim stands on, from 1 on. */
  public int line() {
    return line;
  }

  /** What is wrong with a field that says one number and should say another. */
  static String wrong(String field, long said, long truth) {
    return "the field \"" + field + "\" says " + said + ", but it is " + truth;
  }

  static void unless(boolean truth, String message) {
    unless(truth, 1, message);
  }

  static void unless(boolean truth, int line, String message) {
    if (!truth) {
      throw new FalseClaim(line, message);
    }
  }
}
