package dct.experiment.study;

import dct.core.SeededRandom;

/**
 * One set of sites or one polygon of a study, named so that it can be made again: {@code dct
 * generate} with this shape, number and seed makes the same.
 *
 * @param shape the word of the generator, or the name of the file that the polygon came from
 * @param n the number of vertices
 * @param set which of the sets of this shape and size, from 1
 * @param seed what the generator was given; 0 for a file
 */
public record Trial(String shape, int n, int set, long seed) {
  private static final int KEPT_BITS = 31; // a seed that is short to type

  /** The trial of a plan; its seed depends on the plan's seed, the size and the set alone. */
  static Trial planned(String shape, int n, int set, long planSeed) {
    long seed = mixed(mixed(mixed(planSeed) + n) + set) >>> (64 - KEPT_BITS);
    return new Trial(shape, n, set, Math.max(1, seed));
  }

  private static long mixed(long value) {
    return new SeededRandom(value).nextLong();
  }
}
