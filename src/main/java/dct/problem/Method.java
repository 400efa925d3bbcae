package dct.problem;

import dct.core.Progress;
import dct.core.degree.OddFan;
import dct.core.degree.PartitioningAqt;
import dct.core.geometry.Region;
import dct.core.geometry.Sites;
import dct.core.triangulate.ConstrainedDelaunay;
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
 * The ways to triangulate an instance; the first that is for a domain is its default. Menus, the
 * option {@code --algorithm}, result files and studies all take theirs from this list.
 */
public enum Method {
  MONOTONE(
      Scope.OUTLINES,
      Promise.MONOTONE_PIECES,
      "monotone",
      "Monotone",
      "Monotone Polygon Triangulation",
      "Algorithms 2.2 and 2.3",
      "Cuts the polygon into monotone pieces and triangulates each"),
  EAR_CLIPPING(
      Scope.OUTLINES,
      Promise.TRIANGULATION,
      "ear-clipping",
      "Ear clipping",
      "Ear Clipping Triangulation",
      "Algorithm 2.1",
      "Cuts off one ear of the polygon after the other"),
  CONVEX_EVEN(
      Scope.OUTLINES,
      Promise.CONVEX_PIECES,
      "convex-even",
      "Partitioning-AQT",
      "Convex Polygon Even Triangulation",
      "Algorithm 3.3",
      "Cuts the polygon into convex pieces and makes most vertices of each even"),
  CONVEX_ODD(
      Scope.OUTLINES,
      Promise.CONVEX_PIECES,
      "convex-odd",
      "Odd fans",
      "Convex Polygon Odd Triangulation",
      "Table 4.3",
      "Cuts the polygon into convex pieces and makes most vertices of each odd"),
  CONSTRAINED_DELAUNAY(
      Scope.OUTLINES,
      Promise.EMPTY_CIRCLES,
      "constrained-delaunay",
      "Constrained Delaunay",
      "Constrained Delaunay Triangulation",
      "not in the thesis",
      "Triangulates so that no circle through a triangle's corners holds a vertex seen from it"),
  DELAUNAY(
      Scope.SITES,
      Promise.EMPTY_CIRCLES,
      "delaunay",
      "Delaunay",
      "Delaunay Triangulation",
      "Section 2.2.6",
      "Triangulates the sites so that no circle through a triangle's corners holds a site");

  /** What stands in files in place of {@link #word} where the method is not known. */
  public static final String UNKNOWN = "unknown";

  /** The domains that a method is for. */
  private enum Scope {
    /** Polygons and regions. */
    OUTLINES,
    /** Sites. */
    SITES;

    boolean holds(Domain domain) {
      return switch (this) {
        case OUTLINES -> domain != Domain.SITES;
        case SITES -> domain == Domain.SITES;
      };
    }
  }

  /** What a method promises of every triangulation that it makes. */
  public enum Promise {
    /** No more than that it is one. */
    TRIANGULATION,
    /** The edges of the partition cut the polygon into y-monotone pieces. */
    MONOTONE_PIECES,
    /** The edges of the partition cut the polygon into strictly convex pieces. */
    CONVEX_PIECES,
    /**
     * It is Delaunay: no circle through a triangle's corners has a site inside; or, of an outline,
     * a vertex that is seen from the triangle.
     */
    EMPTY_CIRCLES
  }

  private final Scope scope;
  private final Promise promise;
  private final String word;
  private final String algorithm;
  private final String title;
  private final String source;
  private final String description;

  Method(
      Scope scope,
      Promise promise,
      String word,
      String algorithm,
      String title,
      String source,
      String description) {
    this.scope = scope;
    this.promise = promise;
    this.word = word;
    this.algorithm = algorithm;
    this.title = title;
    this.source = source;
    this.description = description;
  }

  /** Whether it triangulates instances of this domain. */
  public boolean isFor(Domain domain) {
    return scope.holds(domain);
  }

  /** The application of the thesis that it belongs to: polygons or sites, or else regions. */
  public Domain application() {
    return Domain.applications().stream().filter(scope::holds).findFirst().orElse(Domain.REGION);
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
   * Triangulates an instance of one of this method's domains.
   *
   * @throws IllegalArgumentException if the instance is of another domain
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Triangulation run(Instance instance, Progress progress) {
    return switch (this) {
      case MONOTONE -> MonotoneTriangulation.triangulate(region(instance), progress);
      case EAR_CLIPPING -> EarClipping.triangulate(region(instance), progress);
      case CONVEX_EVEN -> PartitioningAqt.triangulate(region(instance), progress);
      case CONVEX_ODD -> OddFan.triangulate(region(instance), progress);
      case CONSTRAINED_DELAUNAY -> ConstrainedDelaunay.triangulate(region(instance), progress);
      case DELAUNAY -> Delaunay.triangulate(sites(instance), progress);
    };
  }

  private Region region(Instance instance) {
    if (instance instanceof Instance.OfPolygon of) {
      return Region.of(of.polygon());
    }
    if (instance instanceof Instance.OfRegion of) {
      return of.region();
    }
    throw notFor(instance);
  }

  private Sites sites(Instance instance) {
    if (instance instanceof Instance.OfSites of) {
      return of.sites();
    }
    throw notFor(instance);
  }

  private IllegalArgumentException notFor(Instance instance) {
    return new IllegalArgumentException(word + " is not for " + instance.domain().word());
  }

  /** The methods for a domain, the default first. */
  public static List<Method> of(Domain domain) {
    return Arrays.stream(values()).filter(method -> method.isFor(domain)).toList();
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
