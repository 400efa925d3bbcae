package dct.cli;

import dct.core.Progress;
import dct.core.degree.OddFan;
import dct.core.degree.PartitioningAqt;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/** The algorithms by their names on the command line; the first of each domain is its default. */
enum Algorithm {
  MONOTONE("monotone", Domain.POLYGON),
  EAR_CLIPPING("ear-clipping", Domain.POLYGON),
  CONVEX_EVEN("convex-even", Domain.POLYGON),
  CONVEX_ODD("convex-odd", Domain.POLYGON),
  DELAUNAY("delaunay", Domain.SITES);

  private final String word;
  private final Domain domain;

  Algorithm(String word, Domain domain) {
    this.word = word;
    this.domain = domain;
  }

  /** The name on the command line. */
  String word() {
    return word;
  }

  /** Runs this algorithm on a shape of its domain. */
  Triangulation triangulate(Shape shape) {
    return switch (this) {
      case MONOTONE -> MonotoneTriangulation.triangulate(shape.polygon(), Progress.NONE);
      case EAR_CLIPPING -> EarClipping.triangulate(shape.polygon(), Progress.NONE);
      case CONVEX_EVEN -> PartitioningAqt.triangulate(shape.polygon(), Progress.NONE);
      case CONVEX_ODD -> OddFan.triangulate(shape.polygon(), Progress.NONE);
      case DELAUNAY -> Delaunay.triangulate(shape.sites(), Progress.NONE);
    };
  }

  /**
   * The algorithm of this name for this domain.
   *
   * @throws UsageException if there is none
   */
  static Algorithm of(String word, Domain domain) {
    if (!isOne(word, domain)) {
      throw new UsageException(
          String.format(
              Locale.ROOT,
              "--algorithm %s is none for %s%s, use %s",
              word,
              domain == Domain.POLYGON ? "a polygon" : "points",
              Spelling.hint(word, List.of(words(domain).split(", "))),
              words(domain)));
    }
    return find(domain, algorithm -> algorithm.word.equals(word));
  }

  /** Whether there is an algorithm of this name for this domain. */
  static boolean isOne(String word, Domain domain) {
    return find(domain, algorithm -> algorithm.word.equals(word)) != null;
  }

  /** The algorithm for this domain unless another is asked for. */
  static Algorithm byDefault(Domain domain) {
    return find(domain, algorithm -> true);
  }

  private static Algorithm find(Domain domain, Predicate<Algorithm> wish) {
    for (Algorithm algorithm : values()) {
      if (algorithm.domain == domain && wish.test(algorithm)) {
        return algorithm;
      }
    }
    return null;
  }

  /** The names for a domain, for messages. */
  static String words(Domain domain) {
    return Arrays.stream(values())
        .filter(a -> a.domain == domain)
        .map(Algorithm::word)
        .collect(Collectors.joining(", "));
  }
}
