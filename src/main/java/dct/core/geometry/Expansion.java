package dct.core.geometry;

/**
 * An exact real number as a sum of doubles that do not overlap, smallest first, without zeros: the
 * expansions of Shewchuk (1997). Most of the numbers met are one or two terms long, which is what
 * keeps lattices fast.
 *
 * <p>Exact as long as no term overflows or underflows; {@link Predicates} sees to that.
 */
final class Expansion {
  private final double[] terms;
  private final int length;

  private Expansion(double[] terms, int length) {
    this.terms = terms;
    this.length = length;
  }

  /** a − b, exactly. */
  static Expansion difference(double a, double b) {
    double high = a - b;
    return ofTwo(twoSumTail(a, -b, high), high);
  }

  private static Expansion ofTwo(double low, double high) {
    if (low != 0) {
      return new Expansion(new double[] {low, high}, 2);
    }
    return new Expansion(new double[] {high}, high == 0 ? 0 : 1);
  }

  /** The exact product. */
  Expansion times(Expansion that) {
    if (length == 1 && that.length == 1) {
      double high = terms[0] * that.terms[0];
      return ofTwo(Math.fma(terms[0], that.terms[0], -high), high);
    }
    Expansion sum = new Expansion(new double[0], 0);
    for (int i = 0; i < that.length; i++) {
      sum = sum.plus(scaled(that.terms[i]));
    }
    return sum;
  }

  private Expansion scaled(double factor) {
    double[] product = new double[2 * length];
    int k = 0;
    double carry = 0;
    for (int i = 0; i < length; i++) {
      double high = terms[i] * factor;
      double low = Math.fma(terms[i], factor, -high);
      double sum = carry + low;
      double tail = twoSumTail(carry, low, sum);
      if (tail != 0) {
        product[k++] = tail;
      }
      carry = high + sum;
      tail = sum - (carry - high);
      if (tail != 0) {
        product[k++] = tail;
      }
    }
    if (carry != 0) {
      product[k++] = carry;
    }
    return new Expansion(product, k);
  }

  /** The exact sum. */
  Expansion plus(Expansion that) {
    return sum(that, 1);
  }

  /** The exact difference. */
  Expansion minus(Expansion that) {
    return sum(that, -1);
  }

  /** Merges the terms by magnitude and distils them, Shewchuk's fast expansion sum. */
  private Expansion sum(Expansion that, double sign) {
    double[] result = new double[length + that.length];
    int i = 0;
    int j = 0;
    int k = 0;
    double carry = 0;
    while (i < length || j < that.length) {
      boolean mine =
          j == that.length || (i < length && Math.abs(terms[i]) < Math.abs(that.terms[j]));
      double term = mine ? terms[i++] : sign * that.terms[j++];
      double sum = carry + term;
      double tail = twoSumTail(carry, term, sum);
      if (tail != 0) {
        result[k++] = tail;
      }
      carry = sum;
    }
    if (carry != 0) {
      result[k++] = carry;
    }
    return new Expansion(result, k);
  }

  /** What a + b lost when it was rounded to {@code sum}, exactly (Knuth's two-sum). */
  static double twoSumTail(double a, double b, double sum) {
    double bVirtual = sum - a;
    return (a - (sum - bVirtual)) + (b - bVirtual);
  }

  /** −1, 0 or 1: the sign of the largest term. */
  int sign() {
    return length == 0 ? 0 : (int) Math.signum(terms[length - 1]);
  }
}
