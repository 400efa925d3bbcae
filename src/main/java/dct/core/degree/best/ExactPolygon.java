package dct.core.degree.best;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.Preference;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.PolygonBounds;
import dct.core.degree.region.ChordTable;
import dct.core.degree.region.ParityTable;
import dct.core.degree.region.PreferredPolygonTable;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.core.triangulate.VisibilityGraph;
import java.util.Arrays;

/**
 * The best triangulations of a simple polygon by the tables over all pairs of vertices that see
 * each other, or over some of them: {@link ParityTable}, and {@link PreferredPolygonTable} where
 * among equally good ones the most preferred is asked for.
 */
final class ExactPolygon {
  /** The pairs of a table of two costs: twice the memory a pair. */
  private static final int MOST_PREFERRED_PAIRS = SearchLimits.MOST_PAIRS / 2;

  private final SimplePolygon polygon;
  private final ParityGoal goal;

  ExactPolygon(SimplePolygon polygon, ParityGoal goal) {
    this.polygon = polygon;
    this.goal = goal;
  }

  /**
   * All pairs that see each other, or null if a table of them would be too large.
   *
   * @param any a triangulation of the polygon
   */
  VisibilityGraph graph(Triangulation any, Progress progress) {
    VisibilityGraph graph = VisibilityGraph.of(polygon, any, SearchLimits.MOST_PAIRS, progress);
    boolean small = graph != null && ParityTable.steps(graph) <= SearchLimits.MOST_STEPS;
    return small ? graph : null;
  }

  /** Whether the table of two costs over these pairs is not too large. */
  static boolean canPrefer(VisibilityGraph graph) {
    return graph.pairs() <= MOST_PREFERRED_PAIRS;
  }

  /** The best triangulation of those whose edges are all in the graph. */
  Triangulation best(VisibilityGraph graph, Progress progress) {
    return cut(ParityTable.fill(graph, ParityTable.costs(wishes()), new int[0], progress));
  }

  /** The most preferred of them. */
  Triangulation best(VisibilityGraph graph, Preference preference, Progress progress) {
    return cut(PreferredPolygonTable.fill(polygon, wishes(), graph, preference, progress));
  }

  private ParityGoal.Wish[] wishes() {
    ParityGoal.Wish[] wishes = new ParityGoal.Wish[polygon.size()];
    Arrays.setAll(wishes, k -> goal.wish(polygon.vertex(k)));
    return wishes;
  }

  private Triangulation cut(ChordTable table) {
    int[] corner = new int[polygon.size()];
    Arrays.setAll(corner, k -> 2 * k); // of the cycle
    Dcel dcel = Dcel.cycle(polygon.walk());
    table.cut(dcel, corner);
    return new Triangulation(Domain.POLYGON, polygon.points(), dcel, edge -> EdgeKind.DIAGONAL);
  }

  /** What the best triangulation of those over all pairs proves. */
  Optimum proven(Triangulation exact) {
    int unmet = goal.unmet(exact);
    LowerBound bound =
        PolygonBounds.of(goal.size(), goal)
            .max(new LowerBound(unmet, "exact table over all triangulations"));
    return new Optimum(exact, goal, unmet, bound, false);
  }
}
