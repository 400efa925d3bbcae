package dct.core.triangulate;

import java.util.Arrays;
import java.util.Optional;

/** What was triangulated. */
public enum Domain {
  /** The inside of a simple polygon: every vertex is on the boundary. */
  POLYGON("polygon"),
  /** The convex hull of point sites. */
  SITES("points");

  private final String word;

  Domain(String word) {
    this.word = word;
  }

  /** The word for it in files and on the command line. */
  public String word() {
    return word;
  }

  /** The domain that a word stands for, or nothing for any other word. */
  public static Optional<Domain> parse(String word) {
    return Arrays.stream(values()).filter(domain -> domain.word.equals(word)).findFirst();
  }
}
