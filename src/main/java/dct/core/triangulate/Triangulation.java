package dct.core.triangulate;

import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import java.util.Arrays;
import java.util.HashSet;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.IntFunction;

/**
 * A triangulation of a simple polygon, a region or point sites; immutable.
 *
 * <p>Vertices have the numbers of the points. Edges are numbered 0 … {@link #edgeCount} − 1 in the
 * order in which the algorithm made them. A polygon with n vertices has n − 3 diagonals and n − 2
 * triangles; a region has {@link Region#triangles}. Sites with h of n on the boundary of their hull
 * have 2n − 2 − h triangles; sites that all lie on one line have none, and their edges form a path.
 */
public final class Triangulation {
  private final Domain domain;
  private final Points points;
  private final Dcel dcel;
  private final byte[] kinds; // by edge: the code

  /**
   * A triangulation over this topology, which is frozen by it.
   *
   * @param inner the kind of each edge that is not on the boundary
   * @throws IllegalArgumentException if an edge was removed from the topology and its number is
   *     still free
   */
  public Triangulation(Domain domain, Points points, Dcel dcel, IntFunction<EdgeKind> inner) {
    if (dcel.edgeBound() != dcel.edgeCount()) {
      throw new IllegalArgumentException("edges are not numbered without gaps");
    }
    this.domain = domain;
    this.points = points;
    this.dcel = dcel.freeze();
    this.kinds = new byte[dcel.edgeCount()];
    for (int edge = 0; edge < kinds.length; edge++) {
      EdgeKind kind = dcel.isBoundary(edge) ? EdgeKind.BOUNDARY : inner.apply(edge);
      kinds[edge] = kind.code;
    }
  }

  /**
   * A triangulation of a region, or of a polygon if it is one.
   *
   * @param inner the kind of each edge that is neither on the boundary nor fixed
   */
  public static Triangulation of(Region region, Dcel dcel, IntFunction<EdgeKind> inner) {
    return new Triangulation(
        region.isPolygon() ? Domain.POLYGON : Domain.REGION,
        region.points(),
        dcel,
        edge ->
            region.isFixed(dcel.origin(2 * edge), dcel.target(2 * edge))
                ? EdgeKind.FIXED
                : inner.apply(edge));
  }

  /** What was triangulated. */
  public Domain domain() {
    return domain;
  }

  /** The vertices. */
  public Points points() {
    return points;
  }

  /** The topology, frozen. */
  public Dcel dcel() {
    return dcel;
  }

  /** The number of vertices, n. */
  public int vertexCount() {
    return points.size();
  }

  /** The number of edges. */
  public int edgeCount() {
    return kinds.length;
  }

  /** The number of triangles. */
  public int triangleCount() {
    return dcel.faceCount() - 1;
  }

  /** The kind of an edge. */
  public EdgeKind kind(int edge) {
    return EdgeKind.of(kinds[edge]);
  }

  /** How many edges are of this kind. */
  public int count(EdgeKind kind) {
    int count = 0;
    for (byte k : kinds) {
      if (k == kind.code) {
        count++;
      }
    }
    return count;
  }

  /** This triangulation with every edge that is neither on the boundary nor fixed a diagonal. */
  public Triangulation plain() {
    return count(EdgeKind.PARTITION) + count(EdgeKind.FLIPPED) == 0 ? this : with(dcel);
  }

  /**
   * Another triangulation of the same: its inner edges are diagonals but for the fixed ones, which
   * it has, too.
   */
  public Triangulation with(Dcel other) {
    Set<Long> fixed = new HashSet<>();
    for (int edge = 0; edge < kinds.length; edge++) {
      if (kinds[edge] == EdgeKind.FIXED.code) {
        fixed.add(Rings.key(from(edge), to(edge)));
      }
    }
    return new Triangulation(
        domain,
        points,
        other,
        edge ->
            !fixed.isEmpty()
                    && fixed.contains(Rings.key(other.origin(2 * edge), other.target(2 * edge)))
                ? EdgeKind.FIXED
                : EdgeKind.DIAGONAL);
  }

  /** One end of an edge: the vertex that half-edge {@code 2 * edge} leaves. */
  public int from(int edge) {
    return dcel.origin(2 * edge);
  }

  /** The other end of an edge. */
  public int to(int edge) {
    return dcel.origin(2 * edge + 1);
  }

  /**
   * The edge between two vertices, if there is one; in as many steps as the one with fewer edges
   * has.
   */
  public OptionalInt edgeBetween(int u, int v) {
    int e = dcel.halfEdge(u, v);
    return e == Dcel.NONE ? OptionalInt.empty() : OptionalInt.of(e >> 1);
  }

  /** The number of edges at vertex v. */
  public int degree(int v) {
    return dcel.degree(v);
  }

  /** Whether vertex v has an even number of edges. */
  public boolean isEven(int v) {
    return (dcel.degree(v) & 1) == 0;
  }

  /**
   * The number of vertices on the boundary, h: all n of a polygon; of a region, those on rings; of
   * sites, those on the hull, the ones inside its edges included.
   */
  public int boundaryCount() {
    boolean[] seen = new boolean[vertexCount()];
    int count = 0;
    for (int edge = 0; edge < kinds.length; edge++) {
      if (kind(edge) == EdgeKind.BOUNDARY) {
        count += mark(seen, from(edge)) + mark(seen, to(edge));
      }
    }
    return count;
  }

  private static int mark(boolean[] seen, int v) {
    int first = seen[v] ? 0 : 1;
    seen[v] = true;
    return first;
  }

  /** The corners of every triangle, counter-clockwise: three vertices a triangle. */
  public int[] triangles() {
    int[] corners = new int[3 * triangleCount()];
    int k = 0;
    for (int f = 1; f < dcel.faceBound(); f++) {
      int e = dcel.faceEdge(f);
      corners[k++] = dcel.origin(e);
      corners[k++] = dcel.origin(dcel.next(e));
      corners[k++] = dcel.origin(dcel.prev(e));
    }
    return Arrays.copyOf(corners, k);
  }
}
