package dct.testing;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.dcel.HalfEdges;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** A triangulation made from nothing but a list of edges, by sorting them round each vertex. */
public final class EdgeGraph {
  private final Points points;
  private final List<int[]> edges = new ArrayList<>();

  /** A graph on these points without an edge. */
  public EdgeGraph(Points points) {
    this.points = points;
  }

  /** Adds an edge. */
  public void add(int from, int to) {
    edges.add(new int[] {from, to});
  }

  /** The triangulation, if that is what the edges are: tests check it. */
  public Triangulation triangulation() {
    int[] origin = new int[2 * edges.size()];
    List<List<Integer>> leaving = new ArrayList<>();
    for (int v = 0; v < points.size(); v++) {
      leaving.add(new ArrayList<>());
    }
    for (int e = 0; e < origin.length; e++) {
      origin[e] = edges.get(e >> 1)[e & 1];
      leaving.get(origin[e]).add(e);
    }
    int[] next = new int[origin.length];
    for (List<Integer> around : leaving) {
      around.sort(Comparator.comparing(this::isLower).thenComparing(this::turn));
      for (int k = 0; k < around.size(); k++) {
        next[around.get((k + 1) % around.size()) ^ 1] = around.get(k);
      }
    }
    Dcel dcel = Dcel.of(points.size(), HalfEdges.of(next, origin), outer(origin), Progress.NONE);
    return new Triangulation(Domain.SITES, points, dcel, edge -> EdgeKind.DIAGONAL);
  }

  private int target(int e) {
    return edges.get(e >> 1)[1 - (e & 1)];
  }

  private int source(int e) {
    return edges.get(e >> 1)[e & 1];
  }

  /** Whether the direction of e is in the lower half of the plane, from 180° up to 360°. */
  private boolean isLower(int e) {
    double dy = points.y(target(e)) - points.y(source(e));
    return dy < 0 || (dy == 0 && points.x(target(e)) < points.x(source(e)));
  }

  private int turn(int e, int f) {
    return -Exact.orient(points, source(e), target(e), target(f));
  }

  /** A half-edge with no point on its left. */
  private int outer(int[] origin) {
    for (int e = 0; e < origin.length; e++) {
      boolean free = true;
      for (int v = 0; v < points.size() && free; v++) {
        free = Exact.orient(points, source(e), target(e), v) <= 0;
      }
      if (free) {
        return e;
      }
    }
    return Dcel.NONE;
  }
}
