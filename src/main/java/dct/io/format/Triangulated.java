package dct.io.format;

import dct.core.geometry.Points;
import java.util.Optional;

/**
 * What the vertices of triangles are taken for: a polygon if all of them are on the rim and the rim
 * is not convex, or else sites.
 */
public final class Triangulated {
  private Triangulated() {}

  /** The shape of vertices with triangles. */
  public static Shape shape(String label, PointColumns vertices, TriangleList triangles) {
    return shape(label, vertices, triangles.faces(vertices.points()));
  }

  /** The shape of vertices with triangles or edges. */
  public static Shape shape(String label, PointColumns vertices, StoredFaces faces) {
    Points points = vertices.points();
    Shape.Kind kind = isConcave(points, faces.rim().ring()) ? Shape.Kind.RING : Shape.Kind.SITES;
    return new Shape(kind, label, points, vertices.lines(), Optional.of(faces));
  }

  /** Whether a ring turns to the left and to the right. */
  private static boolean isConcave(Points points, int[] rim) {
    boolean left = false;
    boolean right = false;
    for (int i = 0; i < rim.length; i++) {
      int v = rim[(i + 1) % rim.length];
      int turn = points.orient(rim[i], v, rim[(i + 2) % rim.length]);
      left |= turn > 0;
      right |= turn < 0;
    }
    return left && right;
  }
}
