package dct.testing;

import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.triangulate.EdgeKind;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/**
 * Whether a mesh triangulates the region inside a ring and outside of holes, without a look at the
 * code under test.
 *
 * <p>Triangles that are all counter-clockwise, whose sides are each boundary edge once and each
 * diagonal once in either direction, cover every point as often as the boundary winds round it:
 * once inside, never outside. So they tile the region. Areas, counts and Euler's formula are
 * checked besides.
 */
final class MeshCheck {
  private final Mesh mesh;
  private final List<int[]> rings; // the boundary, with the inside on the left
  private final int length; // of all rings
  private final int inner; // the number of vertices that are not on it

  private MeshCheck(Mesh mesh, List<int[]> rings) {
    this.mesh = mesh;
    this.rings = rings;
    this.length = rings.stream().mapToInt(ring -> ring.length).sum();
    this.inner = mesh.vertexCount() - length;
  }

  /** The first thing that is wrong, or nothing; the fixed edges are all there, too. */
  static Optional<String> ofRegion(Mesh mesh, Rings rings) {
    ExactArea area = new ExactArea(rings.points());
    List<int[]> turned = new ArrayList<>();
    for (int r = 0; r < rings.count(); r++) {
      int[] ring = rings.ring(r);
      boolean left = area.ofRing(ring).signum() > 0 == (r == 0);
      int[] reversed = new int[ring.length];
      Arrays.setAll(reversed, k -> ring[ring.length - 1 - k]);
      turned.add(left ? ring : reversed);
    }
    MeshCheck check = new MeshCheck(mesh, turned);
    return firstProblem(check, rings.points())
        .or(() -> firstProblemOf(() -> check.checkFixed(rings)));
  }

  private void checkFixed(Rings rings) {
    long[] expected = new long[rings.fixedCount()];
    Arrays.setAll(expected, j -> undirected(rings.fixedFrom(j), rings.fixedTo(j)));
    requireSame(sorted(expected), edges(mesh, EdgeKind.FIXED), "the fixed edges");
  }

  /** The first thing that is wrong, or nothing. */
  static Optional<String> ofPolygon(Mesh mesh, Points polygon) {
    int[] ring = new int[polygon.size()];
    Arrays.setAll(ring, i -> i);
    if (new ExactArea(polygon).ofRing(ring).signum() < 0) {
      Arrays.setAll(ring, i -> ring.length - 1 - i);
    }
    return firstProblem(new MeshCheck(mesh, List.of(ring)), polygon);
  }

  /** The first thing that is wrong, or nothing. */
  static Optional<String> ofSites(Mesh mesh, Points sites) {
    int[] boundary = Hull.boundary(sites);
    MeshCheck check = new MeshCheck(mesh, List.of(boundary));
    return Hull.isStraight(sites, boundary)
        ? firstProblemOf(() -> check.checkPath(sites, boundary))
        : firstProblem(check, sites);
  }

  private static Optional<String> firstProblem(MeshCheck check, Points points) {
    return firstProblemOf(
        () -> {
          check.checkPoints(points);
          check.checkCounts();
          check.checkEdges();
          check.checkBoundary();
          check.checkDegrees();
          check.checkTurns();
          check.checkArea();
          check.checkSides();
        });
  }

  private static Optional<String> firstProblemOf(Runnable checks) {
    try {
      checks.run();
      return Optional.empty();
    } catch (Problem problem) {
      return Optional.of(problem.getMessage());
    }
  }

  private void checkPath(Points sites, int[] ring) {
    checkPoints(sites);
    require(mesh.triangleCount() == 0, () -> mesh.triangleCount() + " triangles on a line");
    require(mesh.edgeCount() == Math.max(0, ring.length - 1), () -> mesh.edgeCount() + " edges");
    long[] expected = new long[mesh.edgeCount()];
    Arrays.setAll(expected, k -> undirected(ring[k], ring[k + 1]));
    requireSame(sorted(expected), edges(mesh, null), "the path along the line");
    checkDegrees();
  }

  private void checkPoints(Points expected) {
    require(mesh.points.equals(expected), () -> "the points are not those given");
  }

  private void checkCounts() {
    int n = mesh.vertexCount();
    int faces = mesh.triangleCount() + rings.size();
    int euler = n - mesh.edgeCount() + faces;
    require(euler == 2, () -> "V − E + F = " + euler);
    int holes = rings.size() - 1;
    int triangles = length - 2 + 2 * inner + 2 * holes;
    requireCount(triangles, mesh.triangleCount(), "triangles");
    int diagonals = length - 3 + 3 * inner + 3 * holes;
    requireCount(diagonals, mesh.edgeCount() - length, "diagonals");
  }

  private void checkEdges() {
    long[] edges = edges(mesh, null);
    for (int k = 0; k < edges.length; k++) {
      long key = edges[k];
      require((int) key != (int) (key >> 32), () -> "loop " + name(key));
      require(k == 0 || key != edges[k - 1], () -> "edge " + name(key) + " twice");
    }
  }

  private void checkBoundary() {
    long[] expected =
        rings.stream()
            .flatMapToLong(
                ring ->
                    IntStream.range(0, ring.length)
                        .mapToLong(k -> undirected(ring[k], ring[(k + 1) % ring.length])))
            .toArray();
    requireSame(sorted(expected), edges(mesh, EdgeKind.BOUNDARY), "the boundary");
  }

  private void checkDegrees() {
    int[] count = new int[mesh.vertexCount()];
    for (int edge = 0; edge < mesh.edgeCount(); edge++) {
      count[mesh.from[edge]]++;
      count[mesh.to[edge]]++;
    }
    for (int v = 0; v < count.length; v++) {
      int vertex = v;
      require(count[v] == mesh.degrees[v], () -> "degree of v" + vertex + " is " + count[vertex]);
    }
  }

  private void checkTurns() {
    int[] t = mesh.triangles;
    for (int k = 0; k < t.length; k += 3) {
      int turn = Exact.orient(mesh.points, t[k], t[k + 1], t[k + 2]);
      int first = k;
      require(turn > 0, () -> triangleName(first) + " is not counter-clockwise");
    }
  }

  private String triangleName(int k) {
    int[] t = mesh.triangles;
    return "triangle v" + t[k] + " v" + t[k + 1] + " v" + t[k + 2];
  }

  private void checkArea() {
    ExactArea area = new ExactArea(mesh.points);
    BigInteger sum = BigInteger.ZERO;
    for (int k = 0; k < mesh.triangles.length; k += 3) {
      sum = sum.add(area.ofRing(Arrays.copyOfRange(mesh.triangles, k, k + 3)));
    }
    BigInteger whole = rings.stream().map(area::ofRing).reduce(BigInteger.ZERO, BigInteger::add);
    require(sum.equals(whole), () -> "the areas of the triangles do not add up");
  }

  private void checkSides() {
    int[] t = mesh.triangles;
    long[] sides = new long[t.length];
    for (int k = 0; k < t.length; k++) {
      sides[k] = directed(t[k], t[k % 3 == 2 ? k - 2 : k + 1]);
    }
    requireSame(expectedSides(), sorted(sides), "the sides of the triangles");
  }

  /** Each boundary edge with the inside on its left, and each other edge in both directions. */
  private long[] expectedSides() {
    long[] expected = new long[2 * mesh.edgeCount() - length];
    int k = 0;
    for (int[] ring : rings) {
      for (int i = 0; i < ring.length; i++) {
        expected[k++] = directed(ring[i], ring[(i + 1) % ring.length]);
      }
    }
    for (int edge = 0; edge < mesh.edgeCount(); edge++) {
      if (mesh.kinds[edge] != EdgeKind.BOUNDARY) {
        expected[k++] = directed(mesh.from[edge], mesh.to[edge]);
        expected[k++] = directed(mesh.to[edge], mesh.from[edge]);
      }
    }
    return sorted(expected);
  }

  /** The edges of one kind, or all for null, sorted. */
  private static long[] edges(Mesh mesh, EdgeKind kind) {
    long[] keys = new long[mesh.edgeCount()];
    int count = 0;
    for (int edge = 0; edge < keys.length; edge++) {
      if (kind == null || mesh.kinds[edge] == kind) {
        keys[count++] = undirected(mesh.from[edge], mesh.to[edge]);
      }
    }
    return sorted(Arrays.copyOf(keys, count));
  }

  private static long directed(int from, int to) {
    return ((long) from << 32) | to;
  }

  private static long undirected(int u, int v) {
    return directed(Math.min(u, v), Math.max(u, v));
  }

  private static long[] sorted(long[] keys) {
    Arrays.sort(keys);
    return keys;
  }

  private static String name(long key) {
    return "v" + (key >> 32) + "–v" + (int) key;
  }

  private static void requireSame(long[] expected, long[] actual, String what) {
    int k = Arrays.mismatch(expected, actual);
    if (k >= 0) {
      String wanted = k < expected.length ? name(expected[k]) : "none";
      String found = k < actual.length ? name(actual[k]) : "none";
      throw new Problem(what + ": " + wanted + " expected, " + found + " found");
    }
  }

  private static void requireCount(int expected, int actual, String what) {
    require(expected == actual, () -> actual + " " + what + ", not " + expected);
  }

  private static void require(boolean holds, Supplier<String> problem) {
    if (!holds) {
      throw new Problem(problem.get());
    }
  }

  private static final class Problem extends RuntimeException {
    private static final long serialVersionUID = 1L;

    Problem(String message) {
      super(message);
    }
  }
}
