package dct.problem;

import java.util.Arrays;
import java.util.Optional;

/** What came after the method that made the first triangulation of a solution. */
public enum Post {
  /** Nothing. */
  NONE("none", false, false),
  /** Flips: those of Scan-Flip, flips by hand, or both. */
  FLIP("flip", false, true),
  /** The optimizer, which does not keep what the method made. */
  OPTIMIZE("optimize", true, false),
  /** The optimizer, and then flips. */
  OPTIMIZE_FLIP("optimize+flip", true, true);

  private final String word;
  private final boolean optimized;
  private final boolean flipped;

  Post(String word, boolean optimized, boolean flipped) {
    this.word = word;
    this.optimized = optimized;
    this.flipped = flipped;
  }

  static Post of(boolean optimized, boolean flipped) {
    return Arrays.stream(values())
        .filter(post -> post.optimized == optimized && post.flipped == flipped)
        .findFirst()
        .orElseThrow();
  }

  /** The word for it in files. */
  public String word() {
    return word;
  }

  /** Whether the optimizer was asked: the triangulation is none that the method promises. */
  public boolean isOptimized() {
    return optimized;
  }

  /** Whether flips came last. */
  public boolean isFlipped() {
    return flipped;
  }

  /** What a word stands for, or nothing for any other word. */
  public static Optional<Post> parse(String word) {
    return Arrays.stream(values()).filter(post -> post.word.equals(word)).findFirst();
  }
}
