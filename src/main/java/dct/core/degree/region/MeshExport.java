package dct.core.degree.region;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.dcel.HalfEdges;
import dct.core.triangulate.Triangulation;
import java.util.Arrays;

/** Turns a {@link SearchMesh} into a triangulation of the same points, in linear time. */
public final class MeshExport {
  private final SearchMesh mesh;
  private final int[] half; // by half-edge of the mesh: its number in the result
  private final int[] outward; // by vertex: the half-edge whose outer side leaves it, or NONE
  private HalfEdges links;
  private int used; // half-edges of the result

  private MeshExport(SearchMesh mesh) {
    this.mesh = mesh;
    half = new int[mesh.corner.length];
    outward = new int[mesh.size()];
    Arrays.fill(outward, SearchMesh.NONE);
  }

  /**
   * The mesh as a triangulation of the points in their own numbers; its edges are numbered along
   * the triangles of the mesh.
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
    Dcel dcel = Dcel.of(mesh.size(), links, linkOutside(last, start), Progress.NONE);
    return start.with(dcel);
  }

  /** Numbers the edge of e if it is first seen; its outer side, if any, gets the odd number. */
  private void number(int e) {
    int twin = mesh.across(e);
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

  /**
   * Links the outer sides. Returns one of each cycle, that round everything first: if it is the
   * only one, that of {@code last}.
   */
  private int[] linkOutside(int last, Triangulation start) {
    int[] cycles = new int[mesh.size()];
    int count = 0;
    int outer = start.dcel().origin(start.dcel().faceEdge(Dcel.OUTER));
    for (int v = SearchMesh.NONE; v < outward.length; v++) {
      int first = v < 0 ? last : outward[v];
      if (first == SearchMesh.NONE) {
        continue;
      }
      cycles[count++] = half[first] + 1;
      if (linkCycle(first, outer)) {
        int swapped = cycles[0];
        cycles[0] = cycles[count - 1];
        cycles[count - 1] = swapped;
      }
    }
    return Arrays.copyOf(cycles, count);
  }

  /** Links the outer sides of a cycle and takes them from the list; whether it has this vertex. */
  private boolean linkCycle(int first, int vertex) {
    boolean contains = false;
    int e = first;
    do {
      int from = mesh.corner[e];
      int following = outward[from];
      links.link(half[e] + 1, half[following] + 1);
      outward[from] = SearchMesh.NONE;
      contains |= mesh.site[from] == vertex;
      e = following;
    } while (e != first);
    return contains;
  }

  private void copy(int e, int following) {
    links.link(half[e], half[following]);
    links.origin()[half[e]] = mesh.site[mesh.corner[e]];
  }
}
