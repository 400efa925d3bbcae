package dct.core.degree.region;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.dcel.HalfEdges;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;

/** Turns a {@link SearchMesh} into a triangulation of the sites, in linear time. */
public final class MeshExport {
  private final SearchMesh mesh;
  private final int[] half; // by half-edge of the mesh: its number in the result
  private final int[] outward; // by vertex: the half-edge of the outer face that leaves it
  private HalfEdges links;

  private MeshExport(SearchMesh mesh) {
    this.mesh = mesh;
    half = new int[mesh.corner.length];
    outward = new int[mesh.size()];
  }

  /**
   * The mesh as a triangulation of the sites in their own numbers; its edges are numbered along the
   * triangles of the mesh.
   *
   * @param start the triangulation that the mesh was made of
   */
  public static Triangulation triangulation(SearchMesh mesh, Triangulation start) {
    return new MeshExport(mesh).triangulation(start);
  }

  private Triangulation triangulation(Triangulation start) {
    links = new HalfEdges(start.edgeCount(), start.edgeCount());
    number();
    int outer = SearchMesh.NONE;
    for (int e = 0; e < half.length; e++) {
      if (isHalfEdge(e)) {
        copy(e);
        outer = mesh.twin[e] == SearchMesh.NONE ? copyOutside(e) : outer;
      }
    }
    Dcel dcel = Dcel.of(mesh.size(), links, outer, Progress.NONE);
    return new Triangulation(start.domain(), start.points(), dcel, edge -> EdgeKind.DIAGONAL);
  }

  private static boolean isHalfEdge(int e) {
    return (e & 3) != 3;
  }

  /** Numbers each edge where it is first seen; its hull side, if any, gets the odd number. */
  private void number() {
    int used = 0;
    for (int e = 0; e < half.length; e++) {
      int twin = mesh.twin[e];
      if (isHalfEdge(e) && (twin == SearchMesh.NONE || twin > e)) {
        half[e] = used;
        if (twin == SearchMesh.NONE) {
          outward[mesh.corner[SearchMesh.next(e)]] = used + 1;
        } else {
          half[twin] = used + 1;
        }
        used += 2;
      }
    }
  }

  private void copy(int e) {
    links.link(half[e], half[SearchMesh.next(e)]);
    links.origin()[half[e]] = mesh.site[mesh.corner[e]];
  }

  private int copyOutside(int e) {
    int h = half[e] + 1;
    links.link(h, outward[mesh.corner[e]]);
    links.origin()[h] = mesh.site[mesh.corner[SearchMesh.next(e)]];
    return h;
  }
}
