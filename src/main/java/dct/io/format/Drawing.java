package dct.io.format;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.problem.Solution;
import java.util.Optional;

/**
 * What is to be written.
 *
 * @param name what formats with a name for it call it
 * @param domain what the points are
 * @param points the points, which need not be a simple polygon
 * @param solution what was made of them, if anything was
 */
public record Drawing(String name, Domain domain, Points points, Optional<Solution> solution) {

  /** Points alone. */
  public static Drawing of(String name, Domain domain, Points points) {
    return new Drawing(name, domain, points, Optional.empty());
  }

  /** A solution; it has the name of its instance. */
  public static Drawing of(Solution solution) {
    return new Drawing(
        solution.instance().name(),
        solution.instance().domain(),
        solution.instance().points(),
        Optional.of(solution));
  }

  /** The triangulation, if there is one. */
  public Optional<Triangulation> triangulation() {
    return solution.map(Solution::triangulation);
  }

  /** Whether the points are a ring. */
  public boolean isRing() {
    return domain == Domain.POLYGON;
  }
}
