package dct.core.triangulate;

import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * A site of a Delaunay triangulation that is moved about, while the triangulation stays as it is:
 * {@link #to} says what is different with the site elsewhere.
 *
 * <p>The site is taken out once, which leaves a hole with other edges in it ({@link SiteHole}). For
 * each new place the edges are found that make room there, and those that the site gets ({@link
 * SiteConflict}). All decisions are exact, and the place may be anywhere: outside the hull, on an
 * edge, on another site. What comes out depends on the place alone, not on the way there, and is a
 * Delaunay triangulation of all sites; where sites are cocircular there may be others.
 *
 * <p>Lives on one thread. Besides what changes, a move costs the walk from the last place.
 */
public final class MovingSite {
  /** Sites with more edges than this are not taken out: that takes quadratic time. */
  public static final int MOST_EDGES = 2_000;

  private final Triangulation start;
  private final Dcel below;
  private final Points points;
  private final int site;
  private final SiteHole hole;
  private int near; // a half-edge at the last place

  private MovingSite(Triangulation start, int site) {
    this.start = start;
    this.site = site;
    below = start.dcel();
    points = start.points();
    hole = new SiteHole(start, site);
    near = hole.rim()[0];
  }

  /**
   * Takes hold of a site, in O(k²) time for k edges.
   *
   * @param delaunay a Delaunay triangulation of sites
   * @return nothing if the site has very many edges, or if all others lie on one line
   */
  public static Optional<MovingSite> of(Triangulation delaunay, int site) {
    if (delaunay.triangleCount() < 2 || delaunay.degree(site) > MOST_EDGES) {
      return Optional.empty();
    }
    MovingSite moving = new MovingSite(delaunay, site);
    return moving.hole.isFlat() ? Optional.empty() : Optional.of(moving);
  }

  /** The triangulation with the site at its first place. */
  public Triangulation start() {
    return start;
  }

  /** The site. */
  public int site() {
    return site;
  }

  /** What is different with the site here. */
  public MovedSite to(double x, double y) {
    if (x == points.x(site) && y == points.y(site)) {
      return new MovedSite(site, x, y, false, List.of(), List.of(), List.of(), List.of());
    }
    SiteConflict conflict = new SiteConflict(hole, x, y, near);
    near = conflict.place();
    Difference difference = new Difference();
    difference.takeOut();
    if (conflict.occupied() < 0) {
      difference.putIn(conflict);
    }
    return difference.of(x, y, conflict.occupied() >= 0);
  }

  /** What the hole and the conflict together come to. */
  private final class Difference {
    private final List<MovedSite.Edge> removed = new ArrayList<>();
    private final List<MovedSite.Edge> added = new ArrayList<>();
    private final Map<Integer, Integer> degrees = new TreeMap<>();
    private final Map<Integer, EdgeKind> kinds =
        new TreeMap<>(); // of edges of the hole; null: none

    /** The edges of the hole are those of its rim, and the new ones that fill it. */
    void takeOut() {
      for (int e : hole.rim()) {
        kinds.put(e >> 1, kind(e));
      }
      for (int e = hole.bound(); e < hole.halfEdgeBound(); e += 2) {
        kinds.put(e >> 1, kind(e));
      }
      int first = below.outEdge(site);
      int e = first;
      do {
        remove(e >> 1);
        e = below.rotate(e);
      } while (e != first);
    }

    private EdgeKind kind(int e) {
      boolean hull = hole.isOuter(e) || hole.isOuter(e ^ 1);
      return hull ? EdgeKind.BOUNDARY : EdgeKind.DIAGONAL;
    }

    void putIn(SiteConflict conflict) {
      for (int e : conflict.removed()) {
        kinds.put(e >> 1, null);
      }
      for (int e : conflict.inward()) {
        kinds.put(e >> 1, EdgeKind.DIAGONAL);
      }
      for (int v : conflict.spokes()) {
        add(site, v, conflict.isHullSpoke(v) ? EdgeKind.BOUNDARY : EdgeKind.DIAGONAL);
      }
    }

    MovedSite of(double x, double y, boolean merged) {
      kinds.forEach(this::compare);
      degrees.remove(site);
      degrees.values().removeIf(change -> change == 0);
      List<Integer> changed = List.copyOf(degrees.keySet());
      List<Integer> now = changed.stream().map(v -> below.degree(v) + degrees.get(v)).toList();
      return new MovedSite(
          site, x, y, merged, List.copyOf(removed), List.copyOf(added), changed, now);
    }

    private void compare(int edge, EdgeKind kind) {
      boolean isNew = 2 * edge >= hole.bound();
      EdgeKind before = isNew ? null : start.kind(edge);
      if (kind != before) {
        if (before != null) {
          remove(edge);
        }
        if (kind != null) {
          add(hole.origin(2 * edge), hole.target(2 * edge), kind);
        }
      }
    }

    private void remove(int edge) {
      removed.add(MovedSite.Edge.of(start.from(edge), start.to(edge), start.kind(edge)));
      count(start.from(edge), start.to(edge), -1);
    }

    private void add(int from, int to, EdgeKind kind) {
      added.add(MovedSite.Edge.of(from, to, kind));
      count(from, to, 1);
    }

    private void count(int from, int to, int by) {
      degrees.merge(from, by, Integer::sum);
      degrees.merge(to, by, Integer::sum);
    }
  }
}
