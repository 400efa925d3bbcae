package dct.core.degree.region;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.dcel.HalfEdges;
import dct.core.triangulate.Triangulation;

/** Turns a {@link SearchMesh} into a triangulation of the sites, in linear time. */
public final class MeshExport {
  private final SearchMesh mesh;
  private final int[] half; // by half-edge of the mesh: its number in the result
  private final int[] outward; // by vertex of the hull: the half-edge whose hull side leaves it
  private HalfEdges links;
  private int used; // half-edges of the result

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
    int last = SearchMesh.NONE; // without a triangle on its other side
    for (int e = 0; e < half.length; e += 4) {
      for (int i = e; i < e + 3; i++) {
        last = mesh.twin[i] == SearchMesh.NONE ? i : last;
        number(i);
      }
      copy(e, e + 1);
      copy(e + 1, e + 2);
      copy(e + 2, e);
    }
    Dcel dcel = Dcel.of(mesh.size(), links, linkOutside(last), Progress.NONE);
    return start.with(dcel);
  }

  /** Numbers the edge of e if it is first seen; its hull side, if any, gets the odd number. */
  private void number(int e) {
    int twin = mesh.twin[e];
    if (twin == SearchMesh.NONE) {
      half[e] = used;
      int target = mesh.corner[SearchMesh.next(e)];
      outward[target] = e;
      links.origin()[used + 1] = mesh.site[target];
      used += 2;
    } else if (twin > e) {
      half[e] = used;
      half[twin] = used + 1;
      used += 2;
    }
  }

  /** Links the hull sides, and returns that of {@code last}. */
  private int linkOutside(int last) {
    int e = last;
    do {
      int following = outward[mesh.corner[e]];
      links.link(half[e] + 1, half[following] + 1);
      e = following;
    } while (e != last);
    return half[last] + 1;
  }

  private void copy(int e, int following) {
    links.link(half[e], half[following]);
    links.origin()[half[e]] = mesh.site[mesh.corner[e]];
  }
}
