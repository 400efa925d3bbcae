package dct.problem;

import dct.core.Progress;
import dct.core.degree.OddFan;
import dct.core.degree.PartitioningAqt;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The ways to triangulate an instance; the first of each domain is its default. Menus, the option
 * {@code --algorithm}, result files and studies all take theirs from this list.
 */
public enum Method {
  MONOTONE(
      Domain.POLYGON,
      Promise.MONOTONE_PIECES,
      "monotone",
      "Monotone",
      "Monotone Polygon Triangulation",
      "Algorithms 2.2 and 2.3",
      "Cuts the polygon into monotone pieces and triangulates each"),
  EAR_CLIPPING(
      Domain.POLYGON,
      Promise.TRIANGULATION,
      "ear-clipping",
      "Ear clipping",
      "Ear Clipping Triangulation",
      "Algorithm 2.1",
      "Cuts off one ear of the polygon after the other"),
  CONVEX_EVEN(
      Domain.POLYGON,
      Promise.CONVEX_PIECES,
      "convex-even",
      "Partitioning-AQT",
      "Convex Polygon Even Triangulation",
      "Algorithm 3.3",
      "Cuts the polygon into convex pieces and makes most vertices of each even"),
  CONVEX_ODD(
      Domain.POLYGON,
      Promise.CONVEX_PIECES,
      "convex-odd",
      "Odd fans",
      "Convex Polygon Odd Triangulation",
      "Table 4.3",
      "Cuts the polygon into convex pieces and makes most vertices of each odd"),
  DELAUNAY(
      Domain.SITES,
      Promise.EMPTY_CIRCLES,
      "delaunay",
      "Delaunay",
      "Delaunay Triangulation",
      "Section 2.2.6",
      "Triangulates the sites so that no circle through a triangle's corners holds a site");

  /** What stands in files in place of {@link #word} where the method is not known. */
  public static final String UNKNOWN = "unknown";

  /** What a method promises of every triangulation that it makes. */
  public enum Promise {
    /** No more than that it is one. */
    TRIANGULATION,
    /** The edges of the partition cut the polygon into y-monotone pieces. */
    MONOTONE_PIECES,
    /** The edges of the partition cut the polygon into strictly convex pieces. */
    CONVEX_PIECES,
    /** It is Delaunay: no circle through a triangle's corners has a site inside. */
    EMPTY_CIRCLES
  }

  private final Domain domain;
  private final Promise promise;
  private final String word;
  private final String algorithm;
  private final String title;
  private final String source;
  private final String description;

  Method(
      Domain domain,
      Promise promise,
      String word,
      String algorithm,
      String title,
      String source,
      String description) {
    this.domain = domain;
    this.promise = promise;
    this.word = word;
    this.algorithm = algorithm;
    this.title = title;
    this.source = source;
    this.description = description;
  }

  /** What it triangulates. */
  public Domain domain() {
    return domain;
  }

  /** What it promises of every triangulation that it makes. */
  public Promise promise() {
    return promise;
  }

  /** Whether it cuts the domain into pieces before it triangulates them. */
  public boolean hasPartition() {
    return promise == Promise.MONOTONE_PIECES || promise == Promise.CONVEX_PIECES;
  }

  /** Its name on the command line and in files. */
  public String word() {
    return word;
  }

  /** The short name of the algorithm, for tables. */
  public String algorithm() {
    return algorithm;
  }

  /** {@link #algorithm} as the name of a column: small letters and underscores. */
  public String column() {
    return algorithm.toLowerCase(Locale.ROOT).replaceAll("[ -]", "_");
  }

  /** Its name in menus and on buttons, as in the thesis. */
  public String title() {
    return title;
  }

  /** Where the thesis has it. */
  public String source() {
    return source;
  }

  /** What it does, in a line. */
  public String description() {
    return description;
  }

  /**
   * Triangulates an instance of this method's domain.
   *
   * @throws IllegalArgumentException if the instance is of the other domain
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Triangulation run(Instance instance, Progress progress) {
    return switch (this) {
      case MONOTONE -> MonotoneTriangulation.triangulate(polygon(instance), progress);
      case EAR_CLIPPING -> EarClipping.triangulate(polygon(instance), progress);
      case CONVEX_EVEN -> PartitioningAqt.triangulate(polygon(instance), progress);
      case CONVEX_ODD -> OddFan.triangulate(polygon(instance), progress);
      case DELAUNAY -> Delaunay.triangulate(sites(instance), progress);
    };
  }

  private SimplePolygon polygon(Instance instance) {
    if (instance instanceof Instance.OfPolygon of) {
      return of.polygon();
    }
    throw new IllegalArgumentException(word + " is not for " + instance.domain().word());
  }

  private Sites sites(Instance instance) {
    if (instance instanceof Instance.OfSites of) {
      return of.sites();
    }
    throw new IllegalArgumentException(word + " is not for " + instance.domain().word());
  }

  /** The methods for a domain, the default first. */
  public static List<Method> of(Domain domain) {
    return Arrays.stream(values()).filter(method -> method.domain == domain).toList();
  }

  /** The method for a domain unless another is asked for. */
  public static Method byDefault(Domain domain) {
    return of(domain).get(0);
  }

  /** The method with this word for this domain, if there is one. */
  public static Optional<Method> of(Domain domain, String word) {
    return of(domain).stream().filter(method -> method.word.equals(word)).findFirst();
  }

  /** The words of the methods for a domain, for messages. */
  public static List<String> words(Domain domain) {
    return of(domain).stream().map(Method::word).toList();
  }
}
