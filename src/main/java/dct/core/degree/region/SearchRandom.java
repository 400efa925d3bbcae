package dct.core.degree.region;

/**
 * Random choices of a search: the same on every machine for the same seed.
 *
 * <p>SplitMix64 (Steele, Lea and Flood 2014). Not for several threads at once.
 */
public final class SearchRandom {
  private static final long STEP = 0x9E3779B97F4A7C15L; // 2^64 over the golden ratio

  private long counter;

  public SearchRandom(long seed) {
    counter = seed;
  }

  /** A stream of its own for part {@code index} of round {@code round}. */
  public static SearchRandom of(long seed, int round, int index) {
    return new SearchRandom(mix(mix(seed + STEP * round) + STEP * index));
  }

  /** The next 32 random bits. */
  public int nextInt() {
    counter += STEP;
    return (int) (mix(counter) >>> 32);
  }

  /** A random number from 0 to {@code bound} − 1, as good as uniform for small bounds. */
  public int below(int bound) {
    return (int) (((nextInt() & 0xFFFFFFFFL) * bound) >>> 32);
  }

  /** A random number from 0, included, to 1, excluded. */
  public double fraction() {
    return (nextInt() >>> 1) * 0x1p-31;
  }

  private static long mix(long value) {
    long z = value;
    z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
    z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
    return z ^ (z >>> 31);
  }
}
