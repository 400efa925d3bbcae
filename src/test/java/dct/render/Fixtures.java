package dct.render;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.degree.FlipResult;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import java.util.List;

/** Triangulations made by hand, so that tests of pictures need no algorithm. */
final class Fixtures {
  /** A square and a point of its right: counter-clockwise with y upwards. */
  static final Points PENTAGON = Points.ofPairs(100, 100, 300, 100, 400, 200, 300, 300, 100, 300);

  private Fixtures() {}

  /** The pentagon cut by v0–v2, a diagonal, and v2–v4, of a decomposition. */
  static Triangulation pentagon() {
    Dcel dcel = Dcel.cycle(0, 1, 2, 3, 4);
    int first = dcel.splitFace(out(dcel, 0), out(dcel, 2));
    int second = dcel.splitFace(inPiece(dcel, first, 2), inPiece(dcel, first, 4));
    return new Triangulation(
        Domain.POLYGON,
        PENTAGON,
        dcel,
        edge -> edge == second >> 1 ? EdgeKind.PARTITION : EdgeKind.DIAGONAL);
  }

  /** The pentagon before and after v0–v2 was flipped to v1–v4. */
  static Solution flippedPentagon() {
    Triangulation before = pentagon();
    Dcel dcel = before.dcel().copy();
    int diagonal = 5;
    dcel.flip(2 * diagonal);
    Triangulation after =
        new Triangulation(
            Domain.POLYGON,
            PENTAGON,
            dcel,
            edge -> edge == diagonal ? EdgeKind.FLIPPED : before.kind(edge));
    return solution().flipped(new FlipResult(before, after, List.of(diagonal)));
  }

  /** The pentagon as a solution. */
  static Solution solution() {
    Instance instance = Instance.of(Domain.POLYGON, "pentagon", PENTAGON, Progress.NONE);
    return Solution.of(instance, Method.CONVEX_EVEN, pentagon());
  }

  private static int out(Dcel dcel, int v) {
    int e = dcel.outEdge(v);
    return dcel.face(e) == Dcel.OUTER ? dcel.rotate(e) : e;
  }

  /** The half-edge that leaves v in the piece left or right of e that has four edges. */
  private static int inPiece(Dcel dcel, int e, int v) {
    int start = dcel.isTriangle(e) ? e ^ 1 : e;
    int at = start;
    while (dcel.origin(at) != v) {
      at = dcel.next(at);
    }
    return at;
  }
}
