package dct.io.format;

import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.problem.Instance;
import dct.problem.Solution;
import java.util.Optional;

/**
 * What is to be written.
 *
 * @param name what formats with a name for it call it
 * @param domain what the points are
 * @param points the points, which need not be a simple polygon
 * @param rings the rings through them, of a region
 * @param solution what was made of them, if anything was
 */
public record Drawing(
    String name, Domain domain, Points points, Optional<Rings> rings, Optional<Solution> solution) {

  /** A polygon or sites. */
  public Drawing(String name, Domain domain, Points points, Optional<Solution> solution) {
    this(name, domain, points, Optional.empty(), solution);
  }

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
        solution.instance() instanceof Instance.OfRegion of
            ? Optional.of(of.region().rings())
            : Optional.empty(),
        Optional.of(solution));
  }

  /** A region alone. */
  public static Drawing of(String name, Rings rings) {
    return new Drawing(name, Domain.REGION, rings.points(), Optional.of(rings), Optional.empty());
  }

  /** The triangulation, if there is one. */
  public Optional<Triangulation> triangulation() {
    return solution.map(Solution::triangulation);
  }

  /**
   * The rings of what has an outline: those of a region, or that of a polygon; nothing of sites.
   */
  public Optional<Rings> outline() {
    return rings.or(() -> Optional.of(points).filter(p -> isRing()).map(Rings::ofChain));
  }

  /**
   * Sees that a format which holds rings alone can hold this.
   *
   * @throws CannotHold if there are sites or fixed edges in a region
   */
  public void requireRingsAlone() throws CannotHold {
    if (rings.isPresent()) {
      Rings all = rings.get();
      String what =
          all.fixedCount() > 0 ? "fixed edges" : all.ringVertices() < points.size() ? "sites" : "";
      if (!what.isEmpty()) {
        throw new CannotHold(
            "it holds no " + what + " inside a region; choose .txt, .json or .poly");
      }
    }
  }

  /** Whether the points are a ring. */
  public boolean isRing() {
    return domain == Domain.POLYGON;
  }
}
