package dct.ui.document;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.problem.Instance;
import java.util.Optional;

/**
 * A state of what is edited; immutable.
 *
 * @param domain which of the two applications it belongs to
 * @param points the vertices of the polygon, or the sites, in the order entered
 * @param wishes the parity that is wished of each vertex, even unless the user said otherwise
 * @param result what was made of the points last, if anything was; sites without a result are shown
 *     with their Delaunay triangulation
 */
public record Document(Domain domain, Points points, ParityGoal wishes, Optional<Result> result) {

  /** A document of which nothing was made yet. */
  public Document(Domain domain, Points points, ParityGoal wishes) {
    this(domain, points, wishes, Optional.empty());
  }

  /** A document in which every vertex is wished to be even. */
  public Document(Domain domain, Points points) {
    this(domain, points, ParityGoal.allEven(points.size()));
  }

  /** A document without vertices. */
  public static Document empty(Domain domain) {
    return new Document(domain, Points.ofPairs());
  }

  /** This document with its vertices at other places; a result of the old ones is left out. */
  public Document with(Points moved) {
    return new Document(domain, moved, wishes);
  }

  /** This document with other wishes; the triangulation stays, what was said of it does not. */
  public Document with(ParityGoal others) {
    return new Document(domain, points, others, result.map(made -> made.wishing(others)));
  }

  /** This document with another result, or none. */
  public Document with(Optional<Result> other) {
    return new Document(domain, points, wishes, other);
  }

  /**
   * The points as an instance with their wishes.
   *
   * @param name what people call it
   * @throws dct.core.geometry.InvalidGeometryException if they cannot be triangulated
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Instance instance(String name, Progress progress) {
    Instance instance = Instance.of(domain, name, points, progress);
    // While a site is dragged over another, one of the two is missing.
    return instance.size() == wishes.size() ? instance.with(wishes) : instance;
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
