package dct.problem;

import dct.core.Progress;
import dct.core.degree.LocalBound;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.Preference;
import dct.core.degree.Preferred;
import dct.core.degree.SearchLimits;
import dct.core.degree.best.BestTriangulation;
import dct.core.degree.best.BoundCheck;
import dct.core.degree.best.RegionOptimizer;
import dct.core.degree.bound.PolygonBounds;
import dct.core.degree.bound.RegionBounds;
import dct.core.degree.bound.SiteBounds;
import dct.core.geometry.Defect;
import dct.core.geometry.InvalidGeometryException;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import java.util.List;
import java.util.Optional;

/**
 * What is to be triangulated: a simple polygon, sites that are not all on one line, or a region
 * with holes, sites and fixed edges inside; with the parity wished of each vertex and a name for
 * people. Immutable.
 *
 * <p>Whether points are usable is decided in {@link #of} and nowhere else, so that mouse, file,
 * clipboard and generator are judged alike.
 */
public sealed interface Instance {

  /**
   * Judges points, in O(n log n).
   *
   * @param name what people call them: a file's name, or "-" for standard input
   * @param points the vertices in boundary order, or the sites; exact duplicates among sites are
   *     merged into the first. A region has one ring then
   * @throws InvalidGeometryException if the polygon is not simple, or the sites are fewer than
   *     three or all on one line
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Instance of(Domain domain, String name, Points points, Progress progress) {
    return switch (domain) {
      case POLYGON -> of(name, SimplePolygon.of(points, progress));
      case SITES -> {
        Sites sites = usable(points, progress);
        yield new OfSites(name, sites, ParityGoal.allEven(sites.size()));
      }
      case REGION -> of(name, Rings.ofChain(points), progress);
    };
  }

  /**
   * Judges rings, in O(n log n).
   *
   * @throws InvalidGeometryException if they bound no region
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static OfRegion of(String name, Rings rings, Progress progress) {
    return of(name, Region.of(rings, progress));
  }

  /** A region, every vertex wished even. */
  static OfRegion of(String name, Region region) {
    return new OfRegion(name, region, ParityGoal.allEven(region.size()));
  }

  /** A polygon that is known to be simple, every vertex wished even. */
  static OfPolygon of(String name, SimplePolygon polygon) {
    return new OfPolygon(name, polygon, ParityGoal.allEven(polygon.size()));
  }

  private static Sites usable(Points points, Progress progress) {
    if (points.size() < 3) {
      throw new InvalidGeometryException(Defect.ofSites(Defect.Kind.FEW_SITES, points));
    }
    Sites sites = Sites.of(points, progress);
    if (sites.areOnOneLine()) {
      throw new InvalidGeometryException(Defect.ofSites(Defect.Kind.SITES_ON_ONE_LINE, points));
    }
    return sites;
  }

  /** What people call it. */
  String name();

  /** What is triangulated: the inside of a polygon or a region, or the hull of sites. */
  Domain domain();

  /** The vertices, with the numbers that triangulations use; merged duplicates have none. */
  Points points();

  /** The parity wished of each vertex. */
  ParityGoal wishes();

  /** The same with other wishes, one for each vertex. */
  Instance with(ParityGoal wishes);

  /** The same under another name. */
  Instance named(String other);

  /** How many exact duplicates were merged. */
  int merged();

  /** What it is, for a person: {@code a simple polygon with 12 vertices, clockwise}. */
  String description();

  /**
   * The triangulation that grants the most wishes, or the best found within the limits.
   *
   * @param start any triangulation of this instance
   */
  Optimum best(Triangulation start, SearchLimits limits, Progress progress);

  /**
   * The same, and of several that grant equally many the most preferred, or the best found.
   *
   * @param start any triangulation of this instance
   */
  Preferred best(
      Triangulation start, SearchLimits limits, Preference preference, Progress progress);

  /**
   * The most preferred of the triangulations that grant the most wishes, proven; or nothing if that
   * would take too much.
   */
  Optional<Preferred> mostPreferred(Preference preference, Progress progress);

  /**
   * The best bound on the wishes that no triangulation grants which takes linear time.
   *
   * @param any any triangulation of this instance
   */
  LowerBound quickBound(Triangulation any);

  /**
   * What can be said of the claim that no triangulation leaves fewer wishes open than this.
   *
   * @param windows whose sum it may be; of sites
   */
  BoundCheck check(int claimed, List<LocalBound> windows, Progress progress);

  /** The number of vertices, merged duplicates not counted. */
  default int size() {
    return points().size();
  }

  /** A remark on merged duplicates, empty if there are none. */
  default String mergedRemark() {
    return merged() == 0
        ? ""
        : " (" + merged() + (merged() == 1 ? " duplicate merged)" : " duplicates merged)");
  }

  /** A simple polygon, holes excluded. */
  record OfPolygon(String name, SimplePolygon polygon, ParityGoal wishes) implements Instance {
    @Override
    public Domain domain() {
      return Domain.POLYGON;
    }

    @Override
    public Points points() {
      return polygon.points();
    }

    @Override
    public Instance with(ParityGoal others) {
      return new OfPolygon(name, polygon, others);
    }

    @Override
    public Instance named(String other) {
      return new OfPolygon(other, polygon, wishes);
    }

    @Override
    public int merged() {
      return 0;
    }

    @Override
    public String description() {
      return "a simple polygon with "
          + size()
          + " vertices, "
          + (polygon.isClockwise() ? "clockwise" : "counter-clockwise");
    }

    @Override
    public Optimum best(Triangulation start, SearchLimits limits, Progress progress) {
      return BestTriangulation.of(polygon, start, wishes, limits, progress);
    }

    @Override
    public Preferred best(
        Triangulation start, SearchLimits limits, Preference preference, Progress progress) {
      return BestTriangulation.of(polygon, start, wishes, limits, preference, progress);
    }

    @Override
    public Optional<Preferred> mostPreferred(Preference preference, Progress progress) {
      return BestTriangulation.mostPreferred(polygon, wishes, preference, progress);
    }

    @Override
    public LowerBound quickBound(Triangulation any) {
      return PolygonBounds.of(size(), wishes);
    }

    @Override
    public BoundCheck check(int claimed, List<LocalBound> windows, Progress progress) {
      return BoundCheck.of(polygon, wishes, claimed, progress);
    }
  }

  /** A region: an outer ring, and holes, sites and fixed edges inside, as far as there are any. */
  record OfRegion(String name, Region region, ParityGoal wishes) implements Instance {
    @Override
    public Domain domain() {
      return Domain.REGION;
    }

    @Override
    public Points points() {
      return region.points();
    }

    @Override
    public Instance with(ParityGoal others) {
      return new OfRegion(name, region, others);
    }

    @Override
    public Instance named(String other) {
      return new OfRegion(other, region, wishes);
    }

    @Override
    public int merged() {
      return 0;
    }

    @Override
    public String description() {
      return "a region with "
          + size()
          + " vertices, "
          + counted(region.holes(), "hole")
          + ", "
          + counted(region.sites(), "site")
          + " and "
          + counted(region.rings().fixedCount(), "fixed edge");
    }

    private static String counted(int count, String what) {
      return count + " " + what + (count == 1 ? "" : "s");
    }

    @Override
    public Optimum best(Triangulation start, SearchLimits limits, Progress progress) {
      return RegionOptimizer.optimize(region, start, wishes, limits, progress);
    }

    @Override
    public Preferred best(
        Triangulation start, SearchLimits limits, Preference preference, Progress progress) {
      return RegionOptimizer.optimize(region, start, wishes, limits, preference, progress);
    }

    @Override
    public Optional<Preferred> mostPreferred(Preference preference, Progress progress) {
      return Optional.empty();
    }

    @Override
    public LowerBound quickBound(Triangulation any) {
      return RegionBounds.of(region, wishes);
    }

    @Override
    public BoundCheck check(int claimed, List<LocalBound> windows, Progress progress) {
      return BoundCheck.of(region, wishes, claimed, progress);
    }
  }

  /** Point sites that span a triangle at least. */
  record OfSites(String name, Sites sites, ParityGoal wishes) implements Instance {
    @Override
    public Domain domain() {
      return Domain.SITES;
    }

    @Override
    public Points points() {
      return sites.points();
    }

    @Override
    public Instance with(ParityGoal others) {
      return new OfSites(name, sites, others);
    }

    @Override
    public Instance named(String other) {
      return new OfSites(other, sites, wishes);
    }

    @Override
    public int merged() {
      return sites.merged();
    }

    @Override
    public String description() {
      return size() + " usable sites" + mergedRemark();
    }

    @Override
    public Optimum best(Triangulation start, SearchLimits limits, Progress progress) {
      return BestTriangulation.of(start, wishes, limits, progress);
    }

    @Override
    public Preferred best(
        Triangulation start, SearchLimits limits, Preference preference, Progress progress) {
      return BestTriangulation.of(start, wishes, limits, preference, progress);
    }

    @Override
    public Optional<Preferred> mostPreferred(Preference preference, Progress progress) {
      return Optional.empty();
    }

    @Override
    public LowerBound quickBound(Triangulation any) {
      return SiteBounds.quick(any, wishes, Progress.NONE);
    }

    @Override
    public BoundCheck check(int claimed, List<LocalBound> windows, Progress progress) {
      return BoundCheck.of(sites, wishes, claimed, windows, progress);
    }
  }
}
