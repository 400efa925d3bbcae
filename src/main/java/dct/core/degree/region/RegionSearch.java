package dct.core.degree.region;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.dcel.Dcel;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.core.triangulate.VisibilityGraph;

/**
 * Takes triangles out of a triangulation of a polygon and puts them back in the best way there is,
 * given the edges that the rest leaves at the vertices between: an exact {@link ParityTable} over a
 * {@link Region}, which may be large.
 *
 * <p>The present triangles are one of the choices, so that the number of unsatisfied vertices never
 * grows. Among choices equally good a random one is taken, by a small random cost of each chord; so
 * the unsatisfied vertices wander until they meet. A region of m vertices costs what its table
 * costs, at most m³/6 steps and in practice far less; no step looks at the whole triangulation.
 */
final class RegionSearch {
  private static final long MOST_STEPS = 200_000_000L; // of one table
  private static final int NOISE = 16; // a chord costs less than this

  private final Triangulation start;
  private final Points points;
  private final ParityGoal goal;
  private final Progress progress;
  private final SeededRandom random;
  private final Region region;
  private final Dcel dcel;

  RegionSearch(Triangulation start, ParityGoal goal, SeededRandom random, Progress progress) {
    this.start = start;
    this.goal = goal;
    this.random = random;
    this.progress = progress;
    points = start.points();
    dcel = start.dcel().copy();
    region = new Region(dcel);
  }

  /** The triangulation as it is now. */
  Triangulation triangulation() {
    return new Triangulation(start.domain(), points, dcel.copy(), edge -> EdgeKind.DIAGONAL);
  }

  /** Whether v has the parity wished, as things are now. */
  boolean isSatisfied(int v) {
    return goal.wish(v).isSatisfiedBy(dcel.degree(v));
  }

  /** How many vertices are unsatisfied as things are now. */
  int countUnsatisfied() {
    int count = 0;
    for (int v = 0; v < points.size(); v++) {
      count += isSatisfied(v) ? 0 : 1;
    }
    return count;
  }

  /**
   * Puts a region of about so many vertices round v back in the best way there is.
   *
   * @return by how much fewer vertices are unsatisfied
   * @throws java.util.concurrent.CancellationException if cancelled; then nothing has changed
   */
  int solveAround(int v, int size) {
    int[] corner = region.grow(dcel, v, size, random);
    SimplePolygon part = polygon(corner);
    Triangulation any = MonotoneTriangulation.triangulate(part, progress);
    VisibilityGraph graph = VisibilityGraph.of(part, any, Integer.MAX_VALUE / 8, progress);
    if (ParityTable.steps(graph) > MOST_STEPS) {
      return 0;
    }
    int before = countUnsatisfied(corner);
    int[] costs = costs(corner);
    ParityTable table = ParityTable.fill(graph, costs, noise(graph.pairs()), progress);
    region.clear(dcel);
    table.cut(dcel, corner);
    return before - countUnsatisfied(corner);
  }

  private SimplePolygon polygon(int[] corner) {
    double[] x = new double[corner.length];
    double[] y = new double[corner.length];
    for (int k = 0; k < corner.length; k++) {
      x[k] = points.x(dcel.origin(corner[k]));
      y[k] = points.y(dcel.origin(corner[k]));
    }
    return SimplePolygon.of(Points.of(x, y), progress);
  }

  private int countUnsatisfied(int[] corner) {
    int count = 0;
    for (int e : corner) {
      count += isSatisfied(dcel.origin(e)) ? 0 : 1;
    }
    return count;
  }

  /** What each parity inside costs at each corner, the edges outside being what they are. */
  private int[] costs(int[] corner) {
    int n = corner.length;
    int[] costs = new int[2 * n];
    int heavy = NOISE * n;
    for (int k = 0; k < n; k++) {
      int outside = region.edgesOutside(dcel, corner[k], corner[(k + n - 1) % n]);
      ParityGoal.Wish wish = goal.wish(dcel.origin(corner[k]));
      costs[2 * k] = wish.isSatisfiedBy(outside) ? 0 : heavy;
      costs[2 * k + 1] = wish.isSatisfiedBy(outside + 1) ? 0 : heavy;
    }
    return costs;
  }

  private int[] noise(int pairs) {
    int[] noise = new int[pairs];
    for (int pair = 0; pair < pairs; pair++) {
      noise[pair] = random.nextInt(NOISE);
    }
    return noise;
  }
}
