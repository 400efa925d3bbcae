package dct.core.degree.best;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.dcel.HalfEdges;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import java.util.Arrays;
import java.util.Optional;

/**
 * Sites of which none lies inside the hull, as the simple polygon with these vertices, straight
 * ones included: its triangulations are those of the sites.
 */
final class HullPolygon {
  private final Triangulation sites;
  private final int[] site; // by vertex of the polygon, counter-clockwise

  private HullPolygon(Triangulation sites) {
    this.sites = sites;
    site = new int[sites.vertexCount()];
    Dcel dcel = sites.dcel();
    int e = dcel.faceEdge(Dcel.OUTER);
    for (int k = 0; k < site.length; k++) {
      site[k] = dcel.origin(e);
      e = dcel.prev(e); // the outer face is walked clockwise
    }
  }

  /** Whether all sites are on the boundary of the hull, and not on one line. */
  static boolean applies(Triangulation sites) {
    return sites.triangleCount() > 0 && sites.boundaryCount() == sites.vertexCount();
  }

  /** The polygon, from any triangulation of the sites. */
  static HullPolygon of(Triangulation sites) {
    return new HullPolygon(sites);
  }

  /**
   * The best triangulation of the sites, or empty if it would take too much.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  Optional<Optimum> optimum(ParityGoal goal, Progress progress) {
    double[] pairs = new double[2 * site.length];
    ParityGoal.Wish[] wishes = new ParityGoal.Wish[site.length];
    for (int k = 0; k < site.length; k++) {
      pairs[2 * k] = sites.points().x(site[k]);
      pairs[2 * k + 1] = sites.points().y(site[k]);
      wishes[k] = goal.wish(site[k]);
    }
    SimplePolygon polygon = SimplePolygon.of(Points.ofPairs(pairs), progress);
    Triangulation any = MonotoneTriangulation.triangulate(polygon, progress);
    return PolygonOptimizer.exact(polygon, ParityGoal.of(wishes), any, progress)
        .map(best -> ofSites(best, goal, progress));
  }

  private Optimum ofSites(Optimum best, ParityGoal goal, Progress progress) {
    Dcel dcel = best.triangulation().dcel();
    int[] next = new int[2 * dcel.edgeCount()];
    int[] origin = new int[next.length];
    Arrays.setAll(next, dcel::next);
    Arrays.setAll(origin, e -> site[dcel.origin(e)]);
    int outer = dcel.faceEdge(Dcel.OUTER);
    Dcel named = Dcel.of(site.length, HalfEdges.of(next, origin), outer, progress);
    Triangulation triangulation =
        new Triangulation(sites.domain(), sites.points(), named, edge -> EdgeKind.DIAGONAL);
    return new Optimum(triangulation, goal, best.unmet(), best.bound(), false);
  }
}
