package dct.core.degree.strip;

import dct.core.SeededRandom;
import dct.core.degree.region.SearchMesh;
import dct.core.degree.region.VertexList;
import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The part of a {@link SearchMesh} between two paths with the same ends, on which each vertex comes
 * after the one before it in a {@link StripOrder}. There may be vertices inside, and the paths may
 * have edges in common.
 *
 * <p>Vertices are named by their rank in that order. Cutting only reads the mesh and costs O(m log
 * m) time for m vertices. Used again for one strip after the other.
 */
final class Strip {
  /**
   * How a strip is cut.
   *
   * @param turn the number of its order
   * @param left at most so many edges of its axis are to the left
   * @param right at most so many are to the right
   * @param down the layers of triangles below the axis
   * @param up the layers of triangles above it
   */
  record Shape(int turn, int left, int right, int down, int up) {}

  private static final int MOST_TRIANGLES = 3000; // where no more layers are added

  final SearchMesh mesh;
  private final StripPath lower;
  private final StripPath upper;
  private final VertexList triangles = new VertexList(); // by their first half-edge
  private final int[] rank; // by vertex of the mesh: its rank if it is in the strip, or NONE
  private int[] vertex = {}; // by rank
  private byte[] wrong; // by rank: as in the mesh if the strip had no triangles
  private int[] onUpper; // by rank: its place on the upper path, or NONE
  private int unmet;

  Strip(SearchMesh mesh) {
    this.mesh = mesh;
    lower = new StripPath(mesh, true);
    upper = new StripPath(mesh, false);
    rank = new int[mesh.size()];
    Arrays.fill(rank, SearchMesh.NONE);
  }

  // ---- cutting

  /**
   * Cuts a strip: an axis goes from v to both sides; the lower path is the axis moved down over
   * layers of triangles, the upper path is the axis moved up.
   */
  void cut(int v, Shape shape, SeededRandom random) {
    StripOrder order = new StripOrder(mesh, shape.turn());
    new StripAxis(mesh, random, order, v).lay(v, shape.left(), shape.right(), lower, upper);
    triangles.clear();
    for (int i = 0; i < shape.down() && triangles.size() < MOST_TRIANGLES; i++) {
      lower.advance(order, triangles);
    }
    for (int i = 0; i < shape.up() && triangles.size() < MOST_TRIANGLES; i++) {
      upper.advance(order, triangles);
    }
    number(order);
    takeOut();
  }

  private void number(StripOrder order) {
    for (int v : vertex) {
      rank[v] = SearchMesh.NONE;
    }
    IntStream corners = triangles.stream().flatMap(t -> Arrays.stream(mesh.corner, t, t + 3));
    IntStream paths = IntStream.concat(lower.vertices(), upper.vertices());
    vertex =
        IntStream.concat(corners, paths)
            .distinct()
            .boxed()
            .sorted(order::compare)
            .mapToInt(v -> v)
            .toArray();
    for (int r = 0; r < vertex.length; r++) {
      rank[vertex[r]] = r;
    }
    onUpper = new int[vertex.length];
    Arrays.fill(onUpper, SearchMesh.NONE);
    for (int place = 0; place < upper.size(); place++) {
      onUpper[rank[upper.vertex(place)]] = place;
    }
  }

  /** Finds how the vertices stand with the triangles taken out. */
  private void takeOut() {
    wrong = new byte[vertex.length];
    unmet = 0;
    for (int r = 0; r < vertex.length; r++) {
      wrong[r] = mesh.wrong[vertex[r]];
      unmet += mesh.isUnmet(vertex[r]) ? 1 : 0;
    }
    triangles.stream().flatMap(t -> Arrays.stream(mesh.corner, t, t + 3)).forEach(this::turn);
  }

  private void turn(int v) {
    wrong[rank[v]] ^= 1;
  }

  // ---- asking

  /** The number of triangles. */
  int triangleCount() {
    return triangles.size();
  }

  /** The number of vertices. */
  int size() {
    return vertex.length;
  }

  /** The vertex of the mesh with this rank; only to be read. */
  int[] vertices() {
    return vertex;
  }

  /** Whether a vertex of the mesh is in the strip. */
  boolean contains(int v) {
    return rank[v] != SearchMesh.NONE;
  }

  /** How many vertices of the strip were unmet when it was cut. */
  int unmet() {
    return unmet;
  }

  /** 1 if the vertex has not the parity wished as long as the strip has no triangles, or else 0. */
  int wrongOutside(int r) {
    return wrong[r];
  }

  /** What it costs if the vertex has not the parity wished: 1, or 0 if any will do. */
  int cost(int r) {
    return mesh.weight[vertex[r]] == 0 ? 0 : 1;
  }

  /** The number of vertices on the lower path. */
  int lowerSize() {
    return lower.size();
  }

  /** The rank of a vertex of the lower path. */
  int lower(int place) {
    return rank[lower.vertex(place)];
  }

  /** Whether a vertex is on the upper path. */
  boolean isOnUpper(int r) {
    return onUpper[r] != SearchMesh.NONE;
  }

  /** Whether two vertices that follow each other on a path do so on the upper path too. */
  boolean isUpperEdge(int a, int b) {
    return onUpper[a] != SearchMesh.NONE && onUpper[b] == onUpper[a] + 1;
  }

  // ---- filling

  /**
   * Replaces the triangles in the mesh by those of a sweep; nothing in the strip may have changed
   * since it was cut.
   */
  void fill(int[] moves) {
    for (int r = 0; r < vertex.length; r++) {
      mesh.wrong[vertex[r]] = wrong[r];
    }
    new StripFilling(mesh, triangles).fill(lower, upper, vertex, moves);
  }
}
