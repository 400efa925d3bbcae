package dct.core.geometry;

/**
 * A number as the unevaluated sum of two doubles, about 106 bits: products and sums of such numbers
 * are within 2⁻¹⁰⁰ of the exact ones, a sum relative to the sum of its operands' magnitudes (T. J.
 * Dekker, <i>A Floating-Point Technique for Extending the Available Precision</i>, 1971).
 *
 * <p>So as long as nothing overflows or underflows; {@link Predicates} sees to that.
 */
record Twofold(double high, double low) {

  /** a − b, exactly. */
  static Twofold difference(double a, double b) {
    double high = a - b;
    return new Twofold(high, Expansion.twoSumTail(a, -b, high));
  }

  Twofold times(Twofold that) {
    double product = high * that.high;
    double tail = Math.fma(high, that.high, -product) + (high * that.low + low * that.high);
    return renormalized(product, tail);
  }

  Twofold plus(Twofold that) {
    double sum = high + that.high;
    double tail = Expansion.twoSumTail(high, that.high, sum);
    return renormalized(sum, tail + (low + that.low));
  }

  Twofold minus(Twofold that) {
    return plus(new Twofold(-that.high, -that.low));
  }

  /** For a tail that is smaller than the head. */
  private static Twofold renormalized(double head, double tail) {
    double high = head + tail;
    return new Twofold(high, tail - (high - head));
  }
}
