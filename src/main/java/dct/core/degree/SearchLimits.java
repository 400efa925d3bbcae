package dct.core.degree;

/**
 * How long a search that is not exact may go on.
 *
 * @param seed of its random choices: the same seed and effort give the same result
 * @param effort how hard to try; 1 is usual, and the number of steps grows in proportion
 * @param seconds a limit on its time, after which it returns the best so far; infinite by default.
 *     Where it strikes, the result depends on the machine.
 */
public record SearchLimits(long seed, double effort, double seconds) {
  /** Seed 1, the usual effort, no limit of time. */
  public static final SearchLimits DEFAULT = new SearchLimits(1, 1, Double.POSITIVE_INFINITY);
}
