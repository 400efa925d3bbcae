package dct.core.degree.best;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.RegionBounds;
import dct.core.degree.region.ParityTable;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import dct.core.triangulate.Sight;
import dct.core.triangulate.Triangulation;
import dct.core.triangulate.VisibilityGraph;
import java.util.Arrays;
import java.util.Optional;

/**
 * The best triangulation of a region with one hole and nothing inside, by the tables of polygons.
 *
 * <p>Let a half-plane at a vertex w lie inside the region as far as it is near w. Then every
 * triangulation has a diagonal from w into the open half-plane: a triangle has no angle of 180° at
 * w, so that one alone cannot cover it. If all vertices that w sees there are on the other ring,
 * each such diagonal cuts the region open to a walk of n + 2 vertices ({@link Slit}), whose
 * triangulations are those of the region with this diagonal, and the table over all pairs that see
 * each other there is exact ({@link ParityTable}). The ends of the diagonal come twice: for each
 * parity of the triangles at the second copies there is a table, in which the first copies are
 * wished what is left. The best of all is the optimum. ∎
 *
 * <p>w and the half-plane are those with the fewest such diagonals, d; there always is one, at a
 * vertex of the hole that is farthest in some direction. 4 d tables, each as for a polygon of n + 2
 * vertices.
 */
final class ExactAnnulus {
  private static final int FORBIDDEN = 1 << 20; // more than all vertices cost
  private static final int GUESSES = 4;

  private final Region region;
  private final ParityGoal goal;
  private final Progress progress;
  private final int from; // w
  private final int[] to; // the ends of its diagonals

  private ExactAnnulus(Region region, ParityGoal goal, int from, int[] to, Progress progress) {
    this.region = region;
    this.goal = goal;
    this.from = from;
    this.to = to;
    this.progress = progress;
  }

  /**
   * The tables for a region; nothing if it is no annulus, has sites or fixed edges, or its vertices
   * see so many others that no table would hold the pairs.
   *
   * @param any a triangulation of the region
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Optional<ExactAnnulus> of(
      Region region, ParityGoal goal, Triangulation any, Progress progress) {
    if (region.holes() != 1 || region.sites() > 0 || region.rings().fixedCount() > 0) {
      return Optional.empty();
    }
    Sight sight = Sight.in(any);
    int from = Points.NONE;
    int[] fewest = null;
    long seen = 0; // each pair from both of its ends
    for (int v = 0; v < region.size(); v++) {
      progress.checkCancelled();
      int[] others = sight.from(v);
      seen += others.length;
      if (seen > 2L * SearchLimits.MOST_PAIRS) {
        return Optional.empty();
      }
      int[] ends = fewest(region, v, others);
      if (ends != null && (fewest == null || ends.length < fewest.length)) {
        from = v;
        fewest = ends;
      }
    }
    return Optional.of(new ExactAnnulus(region, goal, from, fewest, progress));
  }

  /**
   * The fewest vertices in a half-plane that are all on the other ring; null if there is none. In
   * linear time: the half-plane turns with its first vertex.
   */
  private static int[] fewest(Region region, int w, int[] seen) {
    Points points = region.points();
    Rings rings = region.rings();
    int ring = rings.ringOf(w);
    int[] fewest = null;
    int end = 1; // the first vertex behind the half-plane
    int own = 0; // vertices in it that are on the ring of w
    for (int first = 0; first < seen.length; first++) {
      if (first > 0 && first < end && rings.ringOf(seen[first]) == ring) {
        own--;
      }
      end = Math.max(end, first + 1);
      while (end < seen.length && points.orient(w, seen[first], seen[end]) > 0) {
        own += rings.ringOf(seen[end++]) == ring ? 1 : 0;
      }
      boolean isFewer = fewest == null || end - first - 1 < fewest.length;
      if (end < seen.length && own == 0 && isFewer) {
        fewest = Arrays.copyOfRange(seen, first + 1, end);
      }
    }
    return fewest;
  }

  /**
   * The proven optimum, or nothing if the tables are too large or take more steps than this.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  Optional<Optimum> optimum(long mostSteps) {
    Triangulation best = null;
    int unmet = FORBIDDEN;
    int least = RegionBounds.of(region, goal).value();
    for (int k = 0; k < to.length && unmet > least; k++) {
      Slit slit = new Slit(region, to[k], from, progress);
      VisibilityGraph graph = graph(slit);
      if (graph == null || (long) GUESSES * to.length * ParityTable.steps(graph) > mostSteps) {
        return Optional.empty();
      }
      for (int guess = 0; guess < GUESSES && unmet > least; guess++) {
        ParityTable table =
            ParityTable.fill(graph, costs(slit, guess >> 1, guess & 1), new int[0], progress);
        if (table.fewest() < unmet) {
          unmet = table.fewest();
          best = closed(slit, table);
        }
      }
    }
    return Optional.of(proven(best));
  }

  private VisibilityGraph graph(Slit slit) {
    return VisibilityGraph.of(
        slit.points(), slit.dcel(), slit.walk(), SearchLimits.MOST_PAIRS, progress);
  }

  /**
   * The costs by position.
   *
   * @param p the parity of the triangles at the second copy of the one end
   * @param q at that of the other
   */
  private int[] costs(Slit slit, int p, int q) {
    int[] walk = slit.walk();
    int last = walk.length - 1;
    int at = slit.position();
    Wish[] wishes = new Wish[walk.length];
    Arrays.setAll(wishes, k -> walk[k] < region.size() ? goal.wish(walk[k]) : Wish.ANY);
    int[] costs = ParityTable.costs(wishes);
    costs[1 - p] = FORBIDDEN;
    costs[2 * last + 1 - q] = FORBIDDEN;
    exchange(costs, 2 * at, p);
    exchange(costs, 2 * at + 2, q);
    return costs;
  }

  /** Where the second copy has an odd number of triangles, the first one has the other parity. */
  private static void exchange(int[] costs, int at, int parity) {
    if (parity == 1) {
      int even = costs[at];
      costs[at] = costs[at + 1];
      costs[at + 1] = even;
    }
  }

  private Triangulation closed(Slit slit, ParityTable table) {
    int[] walk = slit.walk();
    int[] corner = new int[walk.length];
    Arrays.setAll(corner, k -> 2 * k);
    Dcel dcel = Dcel.cycle(walk);
    table.cut(dcel, corner);
    return slit.closed(dcel, progress);
  }

  private Optimum proven(Triangulation best) {
    int unmet = goal.unmet(best);
    LowerBound table = new LowerBound(unmet, "exact tables over all triangulations, cut open");
    return new Optimum(best, goal, unmet, RegionBounds.of(region, goal).max(table), false);
  }
}
