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
import java.util.Optional;
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

  /** The algorithm of this name, if it is one for this domain. */
  static Optional<Algorithm> of(String word, Domain domain) {
    return Arrays.stream(values())
        .filter(a -> a.word.equals(word) && a.domain == domain)
        .findFirst();
  }

  /** The algorithm for this domain unless another is asked for. */
  static Algorithm byDefault(Domain domain) {
    return Arrays.stream(values()).filter(a -> a.domain == domain).findFirst().orElseThrow();
  }

  /** The names for a domain, for messages. */
  static String words(Domain domain) {
    return Arrays.stream(values())
        .filter(a -> a.domain == domain)
        .map(Algorithm::word)
        .collect(Collectors.joining(", "));
  }
}
