package dct.core;

/**
 * A stream of random numbers that is the same on every machine and JDK.
 *
 * <p>Method: SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators",
 * 2014): a counter that grows by a fixed odd step, each value mixed by two multiplications. Its
 * period is 2^64. Not for secrets, and not for several threads at once: each takes a stream of its
 * own ({@link #of}).
 */
public final class SeededRandom {
  private static final long STEP = 0x9E3779B97F4A7C15L; // 2^64 over the golden ratio

  private long counter;

  /** The stream that belongs to this seed. */
  public SeededRandom(long seed) {
    this.counter = seed;
  }

  /** A stream of its own for part {@code index} of round {@code round}. */
  public static SeededRandom of(long seed, int round, int index) {
    return new SeededRandom(mix(mix(seed + STEP * round) + STEP * index));
  }

  private static long mix(long value) {
    long z = value;
    z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
    z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
    return z ^ (z >>> 31);
  }

  /** The next 64 random bits. */
  public long nextLong() {
    counter += STEP;
    return mix(counter);
  }

  /** The next 32 random bits. */
  public int nextInt() {
    return (int) (nextLong() >>> 32);
  }

  /**
   * The next random integer from 0 to {@code bound} − 1, each equally likely.
   *
   * @throws IllegalArgumentException if the bound is not positive
   */
  public int nextInt(int bound) {
    if (bound <= 0) {
      throw new IllegalArgumentException("bound is " + bound);
    }
    long product;
    long low;
    do { // the few draws that would favour some results are drawn again
      product = (nextLong() >>> 32) * bound;
      low = product & 0xFFFFFFFFL;
    } while (low < bound && low < (1L << 32) % bound); // seldom divided
    return (int) (product >>> 32);
  }

  /**
   * The next random whole number from 0 to {@code bound} − 1, each equally likely.
   *
   * @throws IllegalArgumentException if the bound is not positive
   */
  public long nextLong(long bound) {
    if (bound <= 0) {
      throw new IllegalArgumentException("bound is " + bound);
    }
    long most = Long.MAX_VALUE - (Long.MAX_VALUE % bound + 1) % bound;
    long bits;
    do { // the few draws that would favour some results are drawn again
      bits = nextLong() >>> 1;
    } while (bits > most);
    return bits % bound;
  }

  /** The next random number from 0 (included) to 1 (excluded), a multiple of 2^-53. */
  public double nextDouble() {
    return (nextLong() >>> 11) * 0x1.0p-53;
  }
}
