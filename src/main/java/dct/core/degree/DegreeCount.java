package dct.core.degree;

import dct.core.triangulate.Triangulation;

/**
 * How many vertices have even and how many odd degree.
 *
 * @param even vertices with an even number of edges
 * @param odd vertices with an odd number of edges; itself always even
 */
public record DegreeCount(int even, int odd) {

  /** Counts the vertices of a triangulation, in linear time. */
  public static DegreeCount of(Triangulation triangulation) {
    int odd = 0;
    for (int v = 0; v < triangulation.vertexCount(); v++) {
      odd += triangulation.degree(v) & 1;
    }
    return new DegreeCount(triangulation.vertexCount() - odd, odd);
  }
}
