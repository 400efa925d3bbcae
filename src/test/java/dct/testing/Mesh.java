package dct.testing;

import dct.core.geometry.Points;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;

/** What a triangulation says of itself, as plain arrays that a test may also break. */
final class Mesh {
  Points points;
  int[] from; // one end of each edge
  int[] to; // the other end
  EdgeKind[] kinds; // of each edge
  int[] degrees; // as claimed, of each vertex
  int[] triangles; // three corners a triangle

  static Mesh of(Triangulation t) {
    Mesh mesh = new Mesh();
    mesh.points = t.points();
    mesh.triangles = t.triangles();
    mesh.readEdges(t);
    mesh.degrees = new int[t.vertexCount()];
    for (int v = 0; v < mesh.degrees.length; v++) {
      mesh.degrees[v] = t.degree(v);
    }
    return mesh;
  }

  private void readEdges(Triangulation t) {
    from = new int[t.edgeCount()];
    to = new int[t.edgeCount()];
    kinds = new EdgeKind[t.edgeCount()];
    for (int edge = 0; edge < kinds.length; edge++) {
      from[edge] = t.from(edge);
      to[edge] = t.to(edge);
      kinds[edge] = t.kind(edge);
    }
  }

  int vertexCount() {
    return points.size();
  }

  int edgeCount() {
    return from.length;
  }

  int triangleCount() {
    return triangles.length / 3;
  }
}
