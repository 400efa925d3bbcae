package dct.core.degree;

/**
 * A number that the count of unmet vertices cannot go below, and why.
 *
 * @param value the number
 * @param reason one clause for a person: {@code 12 hull sites, 12 ≡ 0 mod 3}
 */
public record LowerBound(int value, String reason) {

  /** The larger of the two; this one if they are equal. */
  public LowerBound max(LowerBound that) {
    return that.value > value ? that : this;
  }
}
