package dct.core.degree;

/**
 * How long a search that is not exact may go on, and how large an exact one may become.
 *
 * <p>The sizes are fixed: neither free memory nor the number of cores decides what is solved
 * exactly, so that the result is the same on every machine.
 *
 * @param seed of its random choices: the same seed and effort give the same result
 * @param effort how hard to try; 1 is usual, and the number of steps grows in proportion
 * @param seconds a limit on its time, after which it returns the best so far; infinite by default.
 *     Where it strikes, the result depends on the machine.
 */
public record SearchLimits(long seed, double effort, double seconds) {
  /**
   * The pairs of vertices that one exact table may hold: about 40 bytes each, 340 MB in all, which
   * fits a heap of 512 MB, the default of a machine with 2 GB. What is larger is searched, however
   * large the heap; where the heap is smaller the program says that it is, and gives no other
   * result.
   */
  public static final int MOST_PAIRS = 1 << 23;

  /** The steps that one exact table may take: about a minute on two cores. */
  public static final long MOST_STEPS = 20_000_000_000L;

  /** The states that one exact sweep over sites may have: a byte each. */
  public static final long MOST_STATES = 60_000_000;

  /**
   * Seconds that the limit waits, however short it is, for what is quickly done: the first of the
   * thesis's triangulations and the bounds.
   */
  public static final double GRACE = 0.1;

  /** Seed 1, the usual effort, no limit of time. */
  public static final SearchLimits DEFAULT = new SearchLimits(1, 1, Double.POSITIVE_INFINITY);
}
