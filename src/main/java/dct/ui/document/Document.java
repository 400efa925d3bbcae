package dct.ui.document;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.triangulate.Domain;
import dct.io.format.Drawing;
import dct.problem.Instance;
import dct.problem.Solution;
import java.util.Optional;

/**
 * A state of what is edited; immutable.
 *
 * @param domain which of the two applications it belongs to
 * @param points the vertices of the polygon, or the sites
 * @param layout how the vertices of a polygon hang together; plain for sites
 * @param wishes the parity that is wished of each vertex, even unless the user said otherwise
 * @param result what was made of the points last, if anything was; sites without a result are shown
 *     with their Delaunay triangulation
 */
public record Document(
    Domain domain, Points points, Layout layout, ParityGoal wishes, Optional<Result> result) {

  /** A document of which nothing was made yet. */
  public Document(Domain domain, Points points, Layout layout, ParityGoal wishes) {
    this(domain, points, layout, wishes, Optional.empty());
  }

  /** A polygon without holes, or sites, of which nothing was made yet. */
  public Document(Domain domain, Points points, ParityGoal wishes) {
    this(domain, points, Layout.PLAIN, wishes);
  }

  /** A document in which every vertex is wished to be even. */
  public Document(Domain domain, Points points) {
    this(domain, points, ParityGoal.allEven(points.size()));
  }

  /** A polygon of these rings, in which every vertex is wished to be even. */
  public static Document of(Rings rings) {
    Points points = rings.points();
    return new Document(
        Domain.POLYGON, points, Layout.of(rings), ParityGoal.allEven(points.size()));
  }

  /** A document without vertices. */
  public static Document empty(Domain domain) {
    return new Document(domain, Points.ofPairs());
  }

  /** This document with its vertices at other places; a result of the old ones is left out. */
  public Document with(Points moved) {
    return new Document(domain, moved, layout, wishes);
  }

  /** This document with its vertices hanging together otherwise; a result is left out. */
  Document with(Layout other) {
    return new Document(domain, points, other, wishes);
  }

  /** This document with other wishes; the triangulation stays, what was said of it does not. */
  public Document with(ParityGoal others) {
    return new Document(domain, points, layout, others, result.map(made -> made.wishing(others)));
  }

  /** This document with another result, or none. */
  public Document with(Optional<Result> other) {
    return new Document(domain, points, layout, wishes, other);
  }

  /**
   * The points as an instance with their wishes.
   *
   * @param name what people call it
   * @throws dct.core.geometry.InvalidGeometryException if they cannot be triangulated
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Instance instance(String name, Progress progress) {
    Instance instance =
        content() != Domain.REGION
            ? Instance.of(domain, name, points, progress)
            : Instance.of(name, rings(), progress);
    // While a site is dragged over another, one of the two is missing.
    return instance.size() == wishes.size() ? instance.with(wishes) : instance;
  }

  /** The rings of a polygon, and the edges in it that are fixed. */
  public Rings rings() {
    return layout.rings(points);
  }

  /** This document without a hole that has no vertices yet. */
  Document settled() {
    Layout other = layout.settled(size());
    return other.equals(layout) ? this : new Document(domain, points, other, wishes, result);
  }

  /** Whether another document has the same points, hanging together in the same way. */
  public boolean isDrawnAs(Document other) {
    return layout.equals(other.layout) && points.equals(other.points);
  }

  /** Whether this is what an instance was made of, apart from wishes and merged sites. */
  public boolean isOf(Instance instance) {
    return instance instanceof Instance.OfRegion of
        ? content() == Domain.REGION && of.region().rings().hasEdgesOf(rings())
        : content() == instance.domain() && points.equals(instance.points());
  }

  /** What it is for files: a polygon with holes, sites or fixed edges is a region. */
  public Domain content() {
    return layout.settled(size()).isPlain() ? domain : Domain.REGION;
  }

  /**
   * What is written of it.
   *
   * @param name what formats with a name for it call it
   * @param solution what was made of it, if that shall be written
   */
  public Drawing drawing(String name, Optional<Solution> solution) {
    return content() == Domain.REGION
        ? new Drawing(name, Domain.REGION, points, Optional.of(rings()), solution)
        : new Drawing(name, domain, points, solution);
  }

  /** The number of vertices. */
  public int size() {
    return points.size();
  }

  /** The first vertex at exactly this place, or −1. */
  public int vertexAt(double x, double y) {
    for (int v = 0; v < points.size(); v++) {
      if (points.x(v) == x && points.y(v) == y) {
        return v;
      }
    }
    return -1;
  }
}
