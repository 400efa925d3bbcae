package dct.io;

import dct.core.Progress;
import dct.core.degree.FlipResult;
import dct.core.degree.FlipWalk;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.io.format.NoTriangulation;
import dct.io.format.PointColumns;
import dct.io.format.Shape;
import dct.io.format.StoredFaces;
import dct.problem.Method;
import dct.problem.Solution;
import dct.problem.verify.ClaimedEdges;
import dct.problem.verify.Claims;
import dct.problem.verify.FalseClaim;
import dct.problem.verify.Restoration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Makes a solution of the triangles or edges of a file. The vertices of a polygon are put in the
 * order of the rim, where they are not in it already.
 *
 * <p>Edges are proven to be a triangulation by {@link Restoration}. Triangles are so many faces of
 * it then if no two of them lie on one another over an edge and their number is right: on each side
 * of each edge is one of them, so that they cover each place as often as its neighbour, and places
 * at the rim once. Exact; O(n log n).
 */
final class FaceReading {
  private final String source;
  private final StoredFaces faces;
  private final Domain domain;
  private final Shape shape; // in the order of the rim
  private final ClaimedEdges edges;
  private final List<int[]> rings; // of a region

  /** The triangles of a region with these rings, the outer one first. */
  FaceReading(String source, Shape shape, StoredFaces faces, List<int[]> rings) {
    this.source = source;
    this.faces = faces;
    this.domain = Domain.REGION;
    this.rings = rings;
    this.shape = shape;
    this.edges = faces.edges();
  }

  FaceReading(String source, Shape shape, StoredFaces faces, Domain domain) {
    this.source = source;
    this.faces = faces;
    this.domain = domain;
    this.rings = List.of();
    int[] rim = faces.rim().ring();
    boolean inOrder = domain == Domain.SITES || rim.length == 0 || isInOrder(rim);
    this.shape = inOrder ? shape : along(rim, shape);
    this.edges = inOrder ? faces.edges() : along(rim, faces.edges());
  }

  /** Whether the rim goes through the vertices in their order, upwards or downwards. */
  private static boolean isInOrder(int[] rim) {
    int n = rim.length;
    int step = rim[1] == 1 ? 1 : n - 1;
    for (int i = 0; i < n; i++) {
      if (rim[(i + 1) % n] != (rim[i] + step) % n) {
        return false;
      }
    }
    return true;
  }

  private static Shape along(int[] rim, Shape shape) {
    PointColumns columns = new PointColumns();
    for (int v : rim) {
      columns.add(shape.points().x(v), shape.points().y(v), shape.line(v));
    }
    return Shape.of(shape.kind(), shape.label(), columns);
  }

  private static ClaimedEdges along(int[] rim, ClaimedEdges edges) {
    int[] place = new int[rim.length];
    for (int i = 0; i < rim.length; i++) {
      place[rim[i]] = i;
    }
    ClaimedEdges renumbered = new ClaimedEdges();
    for (int i = 0; i < edges.size(); i++) {
      renumbered.add(place[edges.from(i)], place[edges.to(i)], edges.kind(i), edges.line(i));
    }
    return renumbered;
  }

  /** The points in the order of the solution. */
  Shape shape() {
    return shape;
  }

  /**
   * The solution.
   *
   * @throws NoTriangulation if it is none
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  Solution solution(Progress progress) {
    if (faces.fault().isPresent()) {
      throw none(faces.fault().get().line(), faces.fault().get().message());
    }
    try {
      Solution solution = Restoration.of(claims(), progress);
      checkCount(solution.triangulation());
      return faces.flips().isEmpty() ? solution : flipped(solution);
    } catch (FalseClaim lie) {
      throw incomplete(lie.line(), lie.getMessage());
    }
  }

  private Solution flipped(Solution solution) {
    FlipWalk walk = new FlipWalk(solution.triangulation());
    for (int[] edge : faces.flips()) {
      walk.flip(edge[0], edge[1])
          .ifPresent(
              cause -> {
                throw none(0, "flip " + (walk.flips() + 1) + " is impossible: " + cause);
              });
    }
    return solution.withFlips(FlipResult.of(walk));
  }

  /** Where there are several rims it says so. */
  private NoTriangulation incomplete(int line, String why) {
    int rims = faces.rim().rings().size();
    boolean isHole = rims > 1 && domain != Domain.REGION;
    String holes = " rims; read it by --as region";
    return none(line, isHole ? why + ", as at a hole: there are " + rims + holes : why);
  }

  private Claims claims() {
    Map<String, Object> values = new HashMap<>();
    values.put("kind", domain.word());
    values.put("algorithm", Method.UNKNOWN);
    if (domain == Domain.REGION) {
      values.put("rings", rings);
    }
    return new Claims(source, values, shape.points(), shape.lines(), edges, null, List.of());
  }

  /** Checks that no triangle is missing: where one is, an inner edge has but one. */
  private void checkCount(Triangulation made) {
    for (int edge = 0; edge < edges.size() && faces.count() > 0; edge++) {
      boolean single = edges.kind(edge) == EdgeKind.BOUNDARY;
      if (single && !made.dcel().isBoundary(edge)) {
        throw incomplete(edges.line(edge), "on one side of an edge of this triangle is none");
      }
    }
  }

  private NoTriangulation none(int line, String why) {
    return new NoTriangulation(source, faces.what(), domain, line, why);
  }
}
