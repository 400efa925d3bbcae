package dct.bench;

import dct.core.geometry.Predicates;
import java.util.Arrays;
import java.util.Optional;

/**
 * Whether triangles are what was asked for, exactly. Triangles that are all of positive area, whose
 * sides are each boundary edge once and each other edge once in either direction, tile the region
 * within the boundary.
 */
final class TriangleCheck {
  private final double[] x;
  private final double[] y;
  private final int[] corner; // three a triangle, counter-clockwise
  private long[] side; // directed sides, sorted; the triangle is found again by place
  private int[] apex; // by place in side: the corner opposite

  private TriangleCheck(double[] x, double[] y, int[] triangles) {
    this.x = x;
    this.y = y;
    corner = triangles.clone();
  }

  /** What is wrong with a Delaunay triangulation of different sites not all on a line, if any. */
  static Optional<String> ofSites(double[] x, double[] y, int[] triangles) {
    return new TriangleCheck(x, y, triangles).checkSites();
  }

  /** What is wrong with a triangulation of a counter-clockwise simple polygon, if anything. */
  static Optional<String> ofPolygon(double[] x, double[] y, int[] triangles) {
    return new TriangleCheck(x, y, triangles).checkPolygon();
  }

  private Optional<String> checkSites() {
    int boundary = HullCount.of(x, y);
    int expected = 2 * x.length - 2 - boundary;
    if (corner.length != 3 * expected) {
      return Optional.of(corner.length / 3 + " triangles, not " + expected);
    }
    Optional<String> problem = checkTurnsAndSides();
    if (problem.isPresent()) {
      return problem;
    }
    int alone = 0;
    int wrong = 0;
    for (int k = 0; k < side.length; k++) {
      int twin = find(reversed(side[k]));
      alone += twin < 0 ? 1 : 0;
      wrong += twin > k && isInCircle(k, apex[twin]) ? 1 : 0;
    }
    if (alone != boundary) {
      return Optional.of(alone + " sides on the hull, not " + boundary);
    }
    return wrong == 0 ? Optional.empty() : Optional.of(wrong + " edges not Delaunay");
  }

  private Optional<String> checkPolygon() {
    if (corner.length != 3 * (x.length - 2)) {
      return Optional.of(corner.length / 3 + " triangles, not " + (x.length - 2));
    }
    Optional<String> problem = checkTurnsAndSides();
    if (problem.isPresent()) {
      return problem;
    }
    for (long key : side) {
      int from = (int) (key >> 32);
      boolean isEdge = (int) key == (from + 1) % x.length;
      if (isEdge == find(reversed(key)) >= 0) {
        return Optional.of("the sides do not fit the polygon");
      }
    }
    return Optional.empty();
  }

  private Optional<String> checkTurnsAndSides() {
    for (int t = 0; t < corner.length; t += 3) {
      int turn = turn(corner[t], corner[t + 1], corner[t + 2]);
      if (turn == 0) {
        return Optional.of("flat triangles");
      }
      if (turn < 0) {
        int swapped = corner[t];
        corner[t] = corner[t + 1];
        corner[t + 1] = swapped;
      }
    }
    sortSides();
    for (int k = 1; k < side.length; k++) {
      if (side[k] == side[k - 1]) {
        return Optional.of("overlapping triangles");
      }
    }
    return Optional.empty();
  }

  private void sortSides() {
    side = new long[corner.length];
    for (int k = 0; k < side.length; k++) {
      side[k] = ((long) corner[k] << 32) | corner[k % 3 == 2 ? k - 2 : k + 1];
    }
    Arrays.parallelSort(side);
    apex = new int[side.length];
    for (int k = 0; k < side.length; k++) {
      long key = ((long) corner[k] << 32) | corner[k % 3 == 2 ? k - 2 : k + 1];
      apex[find(key)] = corner[k % 3 == 0 ? k + 2 : k - 1];
    }
  }

  private int find(long key) {
    return Arrays.binarySearch(side, key);
  }

  private static long reversed(long key) {
    return (key << 32) | (key >>> 32);
  }

  private boolean isInCircle(int k, int d) {
    int a = (int) (side[k] >> 32);
    int b = (int) side[k];
    int c = apex[k];
    return Predicates.inCircle(x[a], y[a], x[b], y[b], x[c], y[c], x[d], y[d]) > 0;
  }

  private int turn(int a, int b, int c) {
    return Predicates.orient(x[a], y[a], x[b], y[b], x[c], y[c]);
  }
}
