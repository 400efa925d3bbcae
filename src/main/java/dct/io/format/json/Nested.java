package dct.io.format.json;

import dct.io.format.PointColumns;
import java.util.ArrayList;
import java.util.List;

/**
 * Arrays within arrays, innermost pairs of numbers: a point, a list of points, a list of lists (as
 * the rings of a polygon), or a list of those.
 */
final class Nested {
  /** A single point is at depth 1, a list of points at 2, rings at 3, polygons at 4. */
  int depth;

  final List<List<PointColumns>> polygons = new ArrayList<>();
  int beyond; // numbers behind x and y
  double[] numbers = new double[0]; // all, where no array is within the array

  /** The lists of numbers in which points stand one behind the other, if each is read so. */
  final List<PointColumns> flat = new ArrayList<>();

  /** Begins another polygon. */
  void polygon() {
    polygons.add(new ArrayList<>());
  }

  /** Begins another ring. */
  void ring() {
    if (polygons.isEmpty()) {
      polygon();
    }
    polygons.get(polygons.size() - 1).add(new PointColumns());
  }

  /** Adds a point to the last ring. */
  void point(double x, double y, int line) {
    if (polygons.isEmpty() || polygons.get(polygons.size() - 1).isEmpty()) {
      ring();
    }
    List<PointColumns> rings = polygons.get(polygons.size() - 1);
    rings.get(rings.size() - 1).add(x, y, line);
  }

  /**
   * Whether each innermost list holds a ring, {@code [x, y, x, y, …]}, rather than a point of many
   * numbers: there is one only, or they are not equally long.
   */
  boolean isFlat() {
    int lists = rings().stream().mapToInt(PointColumns::size).sum();
    return depth == 2
        && flat.size() == lists
        && (lists == 1 || flat.stream().mapToInt(PointColumns::size).distinct().count() > 1);
  }

  /** All rings that have points, whichever polygon they are of. */
  List<PointColumns> rings() {
    return polygons.stream().flatMap(List::stream).filter(ring -> ring.size() > 0).toList();
  }
}
