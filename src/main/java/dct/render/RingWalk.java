package dct.render;

import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A closed walk along all rings of a region, as a pen that knows polygons without holes fills it:
 * from the first vertex round the outer ring, then to each hole, round it, and back the same way.
 *
 * <p>Ways that are gone to and fro do not change how often the walk winds round a place, wherever
 * they lead. Holes are gone round in the other direction, so that the walk winds once round the
 * places of the region, and not at all round those of a hole.
 */
final class RingWalk {
  private RingWalk() {}

  /** Along the cycles of the outer face. */
  static int[] of(Dcel dcel) {
    int[] starts = dcel.outerCycles();
    IntStream.Builder walk = IntStream.builder();
    for (int start : starts) {
      int e = start;
      do {
        walk.add(dcel.origin(e));
        e = dcel.next(e);
      } while (e != start);
      walk.add(dcel.origin(start)).add(dcel.origin(starts[0]));
    }
    return walk.build().toArray();
  }

  /** Along rings that may run either way. */
  static int[] of(Rings rings) {
    if (rings.ringVertices() == 0) {
      return new int[0];
    }
    IntStream.Builder walk = IntStream.builder();
    for (int r = 0; r < rings.count(); r++) {
      int size = rings.size(r);
      boolean isReversed = isClockwise(rings, r) == (r == 0);
      for (int k = 0; k <= size; k++) {
        int at = k % size;
        walk.add(rings.vertex(r, isReversed && at > 0 ? size - at : at));
      }
      walk.add(rings.vertex(0, 0));
    }
    return walk.build().toArray();
  }

  /** The rings of a walk, without the ways between them. */
  static List<int[]> rings(int... walk) {
    List<int[]> rings = new ArrayList<>();
    for (int first = 0; first < walk.length; ) {
      int end = first + 1;
      while (walk[end] != walk[first]) {
        end++;
      }
      rings.add(Arrays.copyOfRange(walk, first, end));
      first = end + 2;
    }
    return rings;
  }

  /** The sign of the area, computed from the first vertex so that it is not lost in rounding. */
  private static boolean isClockwise(Rings rings, int r) {
    Points points = rings.points();
    double area = 0;
    double x = points.x(rings.vertex(r, 0));
    double y = points.y(rings.vertex(r, 0));
    for (int v : rings.ring(r)) {
      int next = rings.after(v);
      area += (points.x(v) - x) * (points.y(next) - y) - (points.x(next) - x) * (points.y(v) - y);
    }
    return area < 0;
  }
}
