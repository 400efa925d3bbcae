package dct.testing;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * Scan-Flip by its rules, on a bare list of triangles: slow, and sharing nothing with the real one.
 */
public final class ScanFlipReference {

  /** An edge with its smaller end first. */
  public record Edge(int u, int v) implements Comparable<Edge> {
    /** The edge between two vertices. */
    public static Edge of(int a, int b) {
      return new Edge(Math.min(a, b), Math.max(a, b));
    }

    @Override
    public int compareTo(Edge that) {
      return u != that.u ? Integer.compare(u, that.u) : Integer.compare(v, that.v);
    }
  }

  private final Points p;
  private final List<int[]> triangles = new ArrayList<>();
  private final Map<Edge, EdgeKind> kinds;
  private final List<Edge> order = new ArrayList<>(); // as numbered at the beginning
  private final Set<Edge> processed = new HashSet<>();
  private final Set<Edge> made = new HashSet<>();
  private final List<Integer> gains = new ArrayList<>();

  private ScanFlipReference(Triangulation t) {
    p = t.points();
    kinds = edges(t);
    for (int edge = 0; edge < t.edgeCount(); edge++) {
      order.add(Edge.of(t.from(edge), t.to(edge)));
    }
    int[] corners = t.triangles();
    for (int k = 0; k < corners.length; k += 3) {
      triangles.add(new int[] {corners[k], corners[k + 1], corners[k + 2]});
    }
  }

  /** The result of the scan. */
  public static ScanFlipReference run(Triangulation t) {
    ScanFlipReference scan = new ScanFlipReference(t);
    if (t.domain() == Domain.POLYGON) {
      scan.scanVertices();
    } else {
      scan.order.forEach(scan::consider);
    }
    return scan;
  }

  /** Every edge of a triangulation with its kind. */
  public static Map<Edge, EdgeKind> edges(Triangulation t) {
    Map<Edge, EdgeKind> edges = new TreeMap<>();
    for (int edge = 0; edge < t.edgeCount(); edge++) {
      edges.put(Edge.of(t.from(edge), t.to(edge)), t.kind(edge));
    }
    return edges;
  }

  /** The edges afterwards. */
  public Map<Edge, EdgeKind> edges() {
    return kinds;
  }

  /** For each flip, in order, by how much the number of even vertices grew. */
  public List<Integer> gains() {
    return gains;
  }

  private void scanVertices() {
    for (int v = 0; v < p.size(); v++) {
      for (int w : diagonalsFromNext(v)) {
        consider(Edge.of(v, w));
      }
    }
  }

  /**
   * The other ends of v's diagonals, counter-clockwise from the boundary edge with v on its tail.
   */
  private List<Integer> diagonalsFromNext(int v) {
    int w = -1;
    for (Edge edge : kinds.keySet()) {
      int other = edge.u == v ? edge.v : edge.v == v ? edge.u : -1;
      if (other >= 0 && apex(v, other) >= 0 && apex(other, v) < 0) {
        w = other;
      }
    }
    List<Integer> ends = new ArrayList<>();
    for (w = apex(v, w); apex(v, w) >= 0; w = apex(v, w)) {
      ends.add(w);
    }
    return ends;
  }

  /** The third corner of the triangle on the left of u → v, or −1. */
  private int apex(int u, int v) {
    for (int[] t : triangles) {
      for (int k = 0; k < 3; k++) {
        if (t[k] == u && t[(k + 1) % 3] == v) {
          return t[(k + 2) % 3];
        }
      }
    }
    return -1;
  }

  private void consider(Edge d) {
    int a = d.u;
    int b = d.v;
    int c = apex(a, b);
    int e = apex(b, a);
    boolean open = kinds.containsKey(d) && !processed.contains(d) && !made.contains(d);
    if (open && c >= 0 && e >= 0 && isStrictlyConvex(a, e, b, c) && odd(a, b, c, e) > 2) {
      gains.add(2 * odd(a, b, c, e) - 4);
      flip(d, c, e);
    }
  }

  private boolean isStrictlyConvex(int... quadrilateral) {
    return PartitionAssert.isStrictlyConvex(p, quadrilateral);
  }

  private int odd(int... vertices) {
    int odd = 0;
    for (int v : vertices) {
      odd += kinds.keySet().stream().filter(e -> e.u == v || e.v == v).count() % 2 == 1 ? 1 : 0;
    }
    return odd;
  }

  private void flip(Edge d, int c, int e) {
    int a = d.u;
    int b = d.v;
    triangles.removeIf(t -> has(t, a) && has(t, b) && (has(t, c) || has(t, e)));
    triangles.add(new int[] {a, e, c});
    triangles.add(new int[] {b, c, e});
    kinds.remove(d);
    kinds.put(Edge.of(c, e), EdgeKind.FLIPPED);
    made.add(Edge.of(c, e));
    processed.addAll(List.of(Edge.of(a, e), Edge.of(e, b), Edge.of(b, c), Edge.of(c, a)));
  }

  private static boolean has(int[] triangle, int v) {
    return triangle[0] == v || triangle[1] == v || triangle[2] == v;
  }
}
