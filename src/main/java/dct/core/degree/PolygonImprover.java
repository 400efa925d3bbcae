package dct.core.degree;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.core.triangulate.VisibilityGraph;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;

/**
 * Improves a triangulation of a polygon too large for one {@link ParityTable}: again and again, the
 * triangles round an unsatisfied vertex are taken out and put back in the best way there is, given
 * the edges that the rest leaves at the vertices between.
 *
 * <p>Triangles that hang together by diagonals are a simple polygon without holes, since the dual
 * of a triangulated polygon is a tree. The one taken out is grown breadth first to a random size
 * and triangulated anew by the exact table, with the wishes turned round where the rest leaves an
 * odd number of edges. The present triangles are one of its choices, so that nothing gets worse. A
 * round visits the vertices that are unsatisfied when it begins; rounds go on until one of them,
 * with regions at their largest, gains nothing, or the bound is met.
 *
 * <p>A region of m vertices costs what its table costs, at most m³/6 steps and in practice far
 * less; no step looks at the whole polygon.
 */
final class PolygonImprover {
  private static final int[] REGION_SIZES = {60, 150, 400, 1000};
  private static final long MOST_STEPS = 200_000_000L; // of the table of one region
  private static final int IDLE_ROUNDS = 2;

  private final SimplePolygon polygon;
  private final Points points;
  private final ParityGoal goal;
  private final SearchLimits limits;
  private final Progress progress;
  private final SplittableRandom random;
  private final Region region;
  private Dcel dcel;
  private boolean interrupted;

  PolygonImprover(SimplePolygon polygon, ParityGoal goal, SearchLimits limits, Progress progress) {
    this.polygon = polygon;
    this.goal = goal;
    this.limits = limits;
    this.progress = progress;
    points = polygon.points();
    random = new SplittableRandom(limits.seed());
    region = new Region(polygon.size());
  }

  /** The best of what the thesis's own algorithms make of the polygon. */
  static Triangulation thesisBest(SimplePolygon polygon, ParityGoal goal, Triangulation monotone) {
    Triangulation pieces = PartitioningAqt.triangulate(polygon, Progress.NONE);
    Triangulation clipped = EarClipping.triangulate(polygon, Progress.NONE);
    Triangulation best = monotone;
    for (Triangulation other :
        new Triangulation[] {
          ScanFlip.run(monotone).after(),
          pieces,
          ScanFlip.run(pieces).after(),
          ScanFlip.run(clipped).after()
        }) {
      best = goal.unsatisfied(other) < goal.unsatisfied(best) ? other : best;
    }
    return best;
  }

  /** Whether {@link #run} was ended by the time limit or a cancel. */
  boolean wasInterrupted() {
    return interrupted;
  }

  /** The best triangulation found; stops where no more than {@code bound} are unsatisfied. */
  Triangulation run(int bound) {
    Triangulation monotone = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    dcel = thesisBest(polygon, goal, monotone).dcel().copy();
    try {
      improve(bound);
    } catch (CancellationException e) {
      interrupted = true;
    }
    return new Triangulation(Domain.POLYGON, points, dcel, edge -> EdgeKind.DIAGONAL);
  }

  private void improve(int bound) {
    for (int size : REGION_SIZES) {
      int idle = 0;
      while (idle < IDLE_ROUNDS * limits.effort()) {
        int before = countUnsatisfied();
        if (before <= bound) {
          return;
        }
        round(size);
        int gained = before - countUnsatisfied();
        idle = gained > before / 50 ? 0 : idle + 1;
      }
    }
  }

  private int countUnsatisfied() {
    int count = 0;
    for (int v = 0; v < points.size(); v++) {
      count += isSatisfied(v) ? 0 : 1;
    }
    return count;
  }

  private boolean isSatisfied(int v) {
    return goal.wish(v).isSatisfiedBy(dcel.degree(v));
  }

  private void round(int size) {
    for (int k = 0; k < polygon.size(); k++) {
      int v = polygon.vertex(k);
      if (!isSatisfied(v)) {
        progress.report((double) k / polygon.size(), "Improving pieces of " + size + " vertices");
        progress.checkCancelled();
        solveAround(v, size / 2 + random.nextInt(size / 2 + 1));
      }
    }
  }

  /** Puts the region round v back in the best way there is. */
  private void solveAround(int v, int size) {
    int[] corner = region.grow(dcel, v, size, random);
    int n = corner.length;
    double[] x = new double[n];
    double[] y = new double[n];
    ParityGoal.Wish[] wishes = new ParityGoal.Wish[n];
    for (int k = 0; k < n; k++) {
      int w = dcel.origin(corner[k]);
      x[k] = points.x(w);
      y[k] = points.y(w);
      wishes[k] =
          turned(goal.wish(w), region.edgesOutside(dcel, corner[k], corner[(k + n - 1) % n]));
    }
    SimplePolygon part = SimplePolygon.of(Points.of(x, y));
    Triangulation any = MonotoneTriangulation.triangulate(part, Progress.NONE);
    VisibilityGraph graph = VisibilityGraph.of(part, any, Integer.MAX_VALUE / 8, progress);
    if (ParityTable.steps(graph) <= MOST_STEPS) {
      ParityTable table = ParityTable.fill(graph, wishes, progress);
      region.clear(dcel);
      table.cut(dcel, corner);
    }
  }

  /** The wish for the edges inside, given the number of those outside. */
  private static ParityGoal.Wish turned(ParityGoal.Wish wish, int outside) {
    if ((outside & 1) == 0 || wish == ParityGoal.Wish.ANY) {
      return wish;
    }
    return wish == ParityGoal.Wish.EVEN ? ParityGoal.Wish.ODD : ParityGoal.Wish.EVEN;
  }
}
