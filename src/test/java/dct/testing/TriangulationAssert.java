package dct.testing;

import dct.core.dcel.DcelValidator;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.assertj.core.api.AbstractAssert;

/** Checks triangulations independently of the code that makes them; see {@link MeshCheck}. */
public final class TriangulationAssert extends AbstractAssert<TriangulationAssert, Triangulation> {

  private TriangulationAssert(Triangulation actual) {
    super(actual, TriangulationAssert.class);
  }

  /** The entry point. */
  public static TriangulationAssert assertThat(Triangulation actual) {
    return new TriangulationAssert(actual);
  }

  /**
   * The triangles tile the polygon exactly: n − 3 diagonals, n − 2 counter-clockwise triangles, the
   * boundary kept, areas, Euler's formula and degrees right, the laws of the topology kept.
   */
  public TriangulationAssert isTriangulationOf(SimplePolygon polygon) {
    requireDomain(Domain.POLYGON);
    return refuse(MeshCheck.ofPolygon(Mesh.of(actual), polygon.points()));
  }

  /**
   * The triangles tile the convex hull exactly: 2n − 2 − h of them, over all sites; or, of sites on
   * one line, the edges are the path along it.
   */
  public TriangulationAssert isTriangulationOf(Sites sites) {
    requireDomain(Domain.SITES);
    return refuse(MeshCheck.ofSites(Mesh.of(actual), sites.points()));
  }

  /** The triangles tile the region exactly, with all its fixed edges. */
  public TriangulationAssert isTriangulationOf(Region region) {
    requireDomain(region.isPolygon() ? Domain.POLYGON : Domain.REGION);
    return refuse(MeshCheck.ofRegion(Mesh.of(actual), region.rings()));
  }

  private void requireDomain(Domain domain) {
    isNotNull();
    DcelValidator.validate(actual.dcel());
    if (actual.domain() != domain) {
      failWithMessage("a triangulation of %s, not of %s", actual.domain(), domain);
    }
  }

  private TriangulationAssert refuse(Optional<String> problem) {
    problem.ifPresent(text -> failWithMessage("%s", text));
    return this;
  }

  /** No site lies inside the circle of a triangle: every inner edge passes the exact test. */
  public TriangulationAssert isDelaunay() {
    isNotNull();
    int[] t = actual.triangles();
    Map<Long, Integer> apex = new HashMap<>();
    for (int k = 0; k < t.length; k++) {
      apex.put(key(t[k], t[k % 3 == 2 ? k - 2 : k + 1]), t[k % 3 == 0 ? k + 2 : k - 1]);
    }
    for (int k = 0; k < t.length; k += 3) {
      requireEmptyCircle(apex, t[k], t[k + 1], t[k + 2]);
    }
    return this;
  }

  private void requireEmptyCircle(Map<Long, Integer> apex, int a, int b, int c) {
    for (Long side : new long[] {key(b, a), key(c, b), key(a, c)}) {
      Integer d = apex.get(side);
      if (d != null && Exact.inCircle(actual.points(), a, b, c, d) > 0) {
        failWithMessage("v%d lies inside the circle of v%d v%d v%d", d, a, b, c);
      }
    }
  }

  private static long key(int from, int to) {
    return ((long) from << 32) | to;
  }

  /** Besides the boundary there are only edges of these kinds. */
  public TriangulationAssert hasInnerEdgesOnlyOf(EdgeKind... allowed) {
    isNotNull();
    EnumSet<EdgeKind> kinds = EnumSet.of(EdgeKind.BOUNDARY, allowed);
    for (int edge = 0; edge < actual.edgeCount(); edge++) {
      if (!kinds.contains(actual.kind(edge))) {
        failWithMessage(
            "v%d–v%d is of kind %s", actual.from(edge), actual.to(edge), actual.kind(edge));
      }
    }
    return this;
  }

  /** The edges of this kind, as a sorted array of pairs with the smaller number first. */
  public static long[] edgesOfKind(Triangulation t, EdgeKind kind) {
    long[] keys = new long[t.count(kind)];
    int k = 0;
    for (int edge = 0; edge < t.edgeCount(); edge++) {
      if (t.kind(edge) == kind) {
        int u = t.from(edge);
        int v = t.to(edge);
        keys[k++] = key(Math.min(u, v), Math.max(u, v));
      }
    }
    Arrays.sort(keys);
    return keys;
  }
}
