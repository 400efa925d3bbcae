package dct.io.format.mesh;

import dct.core.geometry.Points;
import dct.io.format.PointColumns;
import dct.io.format.Rim;
import dct.io.format.Shape;
import java.util.ArrayList;
import java.util.List;

/** The rings that segments between numbered vertices make, and which of them are holes. */
final class Chains {
  private final Rim segments;
  private int onRings;
  private int idleHoles;

  /** Of segments that are all there. */
  Chains(Rim segments) {
    this.segments = segments;
  }

  /**
   * The rings in the order of their first vertices, holes last. The innermost ring round a hole's
   * point is a hole.
   */
  List<Shape> rings(Points points, int[] lines, Points holes) {
    List<int[]> rings = segments.rings();
    boolean[] isHole = new boolean[rings.size()];
    for (int ring : Nest.innermost(points, rings, holes)) {
      if (ring >= 0) {
        isHole[ring] = true;
      } else {
        idleHoles++;
      }
    }
    List<Shape> outer = new ArrayList<>();
    List<Shape> inner = new ArrayList<>();
    for (int r = 0; r < isHole.length; r++) {
      PointColumns ring = new PointColumns();
      for (int v : rings.get(r)) {
        ring.add(points.x(v), points.y(v), lines[v]);
      }
      onRings += ring.size();
      (isHole[r] ? inner : outer)
          .add(Shape.of(isHole[r] ? Shape.Kind.HOLE : Shape.Kind.RING, "", ring));
    }
    outer.addAll(inner);
    return outer;
  }

  int verticesApart() {
    return segments.vertices() - onRings;
  }

  /** How many points of holes lie in no ring. */
  int idleHoles() {
    return idleHoles;
  }

  int looseSegments() {
    return segments.edges() - onRings;
  }
}
