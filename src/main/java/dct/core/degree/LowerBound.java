package dct.core.degree;

import java.util.List;

/**
 * A number that the count of unmet vertices cannot go below, and why.
 *
 * @param value the number
 * @param reason one clause for a person: {@code 12 hull sites, 12 ≡ 0 mod 3}
 * @param windows what it is the sum of, before it is rounded up, if it is such a sum; otherwise
 *     none
 */
public record LowerBound(int value, String reason, List<LocalBound> windows) {

  /** Checks nothing; takes a copy of the windows. */
  public LowerBound {
    windows = List.copyOf(windows);
  }

  /** A bound that is no sum over windows. */
  public LowerBound(int value, String reason) {
    this(value, reason, List.of());
  }

  /** The larger of the two; this one if they are equal. */
  public LowerBound max(LowerBound that) {
    return that.value > value ? that : this;
  }
}
