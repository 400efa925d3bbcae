package dct.io.format;

import dct.core.geometry.Points;
import dct.core.triangulate.EdgeKind;
import dct.problem.verify.ClaimedEdges;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * A growing list of triangles as they stand in a file, from which their edges are made.
 *
 * <p>Triangles that lie on one another over a common edge are found here: an edge has one triangle
 * on each side at most. Exact; linear.
 */
public final class TriangleList {
  private int[] corners = new int[48];
  private int[] lines = new int[16];
  private int size;

  /** Adds the triangle on this line; its corners are vertices that there are. */
  public void add(int a, int b, int c, int line) {
    if (size == lines.length) {
      lines = Arrays.copyOf(lines, Math.multiplyExact(2, size));
      corners = Arrays.copyOf(corners, Math.multiplyExact(2, corners.length));
    }
    corners[3 * size] = a;
    corners[3 * size + 1] = b;
    corners[3 * size + 2] = c;
    lines[size++] = line;
  }

  /** How many there are. */
  public int size() {
    return size;
  }

  /** The edges of the triangles, those with one triangle as boundary. */
  public StoredFaces faces(Points points) {
    return new Sides(points).faces();
  }

  /** The sides of all triangles: side k is opposite to corner k. */
  private final class Sides {
    private final Points points;
    private final ClaimedEdges edges = new ClaimedEdges();
    private final Rim rim;
    private int faultLine = Integer.MAX_VALUE;
    private String fault = "";

    Sides(Points points) {
      this.points = points;
      this.rim = new Rim(points.size());
    }

    StoredFaces faces() {
      checkCorners();
      int[] sorted = sorted(sorted(null, true), false);
      int from = 0;
      for (int i = 1; i <= sorted.length; i++) {
        if (i == sorted.length || !isSame(sorted[i], sorted[from])) {
          edge(sorted, from, i);
          from = i;
        }
      }
      Optional<StoredFaces.Fault> found =
          fault.isEmpty() ? Optional.empty() : Optional.of(new StoredFaces.Fault(faultLine, fault));
      return new StoredFaces("triangles", edges, size, rim, found, List.of());
    }

    private void checkCorners() {
      for (int t = 0; t < size; t++) {
        int a = corners[3 * t];
        int b = corners[3 * t + 1];
        int c = corners[3 * t + 2];
        if (a == b || b == c || c == a) {
          fault(lines[t], "the triangle has the same corner twice");
        } else if (points.orient(a, b, c) == 0) {
          fault(lines[t], "the corners of the triangle are on one line");
        }
      }
    }

    /** The first fault is kept. */
    private void fault(int line, String message) {
      if (line < faultLine) {
        faultLine = line;
        fault = message;
      }
    }

    private int from(int side) {
      return corners[side - side % 3 + (side + 1) % 3];
    }

    private int to(int side) {
      return corners[side - side % 3 + (side + 2) % 3];
    }

    private int key(int side, boolean high) {
      return high ? Math.max(from(side), to(side)) : Math.min(from(side), to(side));
    }

    private boolean isSame(int side, int its) {
      return key(side, false) == key(its, false) && key(side, true) == key(its, true);
    }

    /** All sides by one of their ends, in the order before where that is the same. */
    private int[] sorted(int[] before, boolean high) {
      int[] first = new int[points.size() + 1];
      for (int side = 0; side < 3 * size; side++) {
        first[key(side, high) + 1]++;
      }
      Arrays.parallelPrefix(first, Integer::sum);
      int[] after = new int[3 * size];
      for (int i = 0; i < after.length; i++) {
        int side = before == null ? i : before[i];
        after[first[key(side, high)]++] = side;
      }
      return after;
    }

    /** Adds the edge that these sides are, which are in the order of their triangles. */
    private void edge(int[] sorted, int start, int end) {
      int u = key(sorted[start], false);
      int v = key(sorted[start], true);
      if (end - start == 1) {
        edges.add(u, v, EdgeKind.BOUNDARY, lines[sorted[start] / 3]);
        rim.add(u, v);
        return;
      }
      edges.add(u, v, EdgeKind.DIAGONAL, lines[sorted[start] / 3]);
      for (int i = start + 1; i < end; i++) {
        for (int k = start; k < Math.min(i, start + 2); k++) {
          checkSides(u, v, sorted[k], sorted[i]);
        }
      }
    }

    private void checkSides(int u, int v, int side, int next) {
      int apex = corners[side];
      int its = corners[next];
      if (apex == its) {
        fault(lines[next / 3], "the triangle is there already, on line " + lines[side / 3]);
      } else if (points.orient(u, v, apex) == points.orient(u, v, its)) {
        fault(lines[next / 3], "the triangle lies on that of line " + lines[side / 3]);
      }
    }
  }
}
