package dct.io;

import dct.core.triangulate.Domain;
import java.util.Optional;

/** The words for a domain in files and on the command line: {@code polygon} and {@code points}. */
public final class DomainWord {
  private static final String POLYGON = "polygon";
  private static final String POINTS = "points";

  private DomainWord() {}

  /** The word for a domain. */
  public static String of(Domain domain) {
    return domain == Domain.POLYGON ? POLYGON : POINTS;
  }

  /** The domain that a word stands for, or nothing for any other word. */
  public static Optional<Domain> parse(String word) {
    return switch (word) {
      case POLYGON -> Optional.of(Domain.POLYGON);
      case POINTS -> Optional.of(Domain.SITES);
      default -> Optional.empty();
    };
  }
}
