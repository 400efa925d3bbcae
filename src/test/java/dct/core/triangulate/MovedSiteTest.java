package dct.core.triangulate;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.dcel.DcelValidator;
import dct.core.geometry.Points;
import dct.core.geometry.Predicates;
import dct.core.geometry.Sites;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * A site is dragged: it is taken out of the Delaunay triangulation and put in elsewhere by the
 * operators of {@link Dcel} alone, and the triangulation is Delaunay again, as if made anew.
 */
class MovedSiteTest {

  @Test
  void theEdgesAreThoseOfANewTriangulation() {
    for (int seed = 0; seed < 30; seed++) {
      Random random = new Random(seed);
      int n = 12 + random.nextInt(60);
      double[] x = random.doubles(n).toArray();
      double[] y = random.doubles(n).toArray();
      System.arraycopy(new double[] {-1, 2, 2.5, -1.5}, 0, x, 0, 4); // so that all else is inside
      System.arraycopy(new double[] {-1, -1.5, 2, 2.5}, 0, y, 0, 4);
      Drag drag = new Drag(x, y);
      for (int step = 0; step < 25; step++) {
        int v = drag.innerVertex(random);
        drag.move(v, 0.3 + 0.4 * random.nextDouble(), 0.3 + 0.4 * random.nextDouble());
        DcelValidator.validate(drag.dcel);
        assertThat(drag.edges()).as("seed %d, step %d", seed, step).isEqualTo(drag.newEdges());
      }
    }
  }

  /** On a grid sites lie on edges and on common circles: any Delaunay triangulation is right. */
  @Test
  void onAGridEveryEdgeIsDelaunay() {
    for (int seed = 0; seed < 30; seed++) {
      Random random = new Random(seed);
      int side = 5;
      double[] x = new double[side * side];
      double[] y = new double[side * side];
      for (int v = 0; v < x.length; v++) {
        x[v] = 2 * (v % side);
        y[v] = 2 * (v / side);
      }
      Drag drag = new Drag(x, y);
      for (int step = 0; step < 60; step++) {
        int v = drag.innerVertex(random);
        double px = 1 + random.nextInt(2 * side - 3);
        double py = 1 + random.nextInt(2 * side - 3);
        if (drag.isFree(px, py)) {
          drag.move(v, px, py);
          DcelValidator.validate(drag.dcel);
          assertThat(drag.illegalEdges()).as("seed %d, step %d", seed, step).isZero();
          assertThat(drag.dcel.faceCount()).isEqualTo(drag.newTriangulation().dcel().faceCount());
        }
      }
    }
  }

  /** The topology, the sites, and the edges that may have to be flipped. */
  private static final class Drag {
    private final double[] x;
    private final double[] y;
    private final Dcel dcel;
    private final Deque<Integer> suspects = new ArrayDeque<>();

    Drag(double[] x, double[] y) {
      this.x = x;
      this.y = y;
      dcel = newTriangulation().dcel().copy();
    }

    Triangulation newTriangulation() {
      return Delaunay.triangulate(Sites.of(Points.of(x, y), Progress.NONE), Progress.NONE);
    }

    int innerVertex(Random random) {
      while (true) {
        int v = random.nextInt(x.length);
        int e = dcel.outEdge(v);
        int turns = 0;
        while (dcel.face(e) != Dcel.OUTER && turns < dcel.degree(v)) {
          e = dcel.rotate(e);
          turns++;
        }
        if (turns == dcel.degree(v)) {
          return v;
        }
      }
    }

    boolean isFree(double px, double py) {
      for (int v = 0; v < x.length; v++) {
        if (x[v] == px && y[v] == py) {
          return false;
        }
      }
      return true;
    }

    void move(int v, double px, double py) {
      int near = remove(v);
      x[v] = px;
      y[v] = py;
      insert(v, locate(near, v));
    }

    /** Returns a half-edge near the place where v was. */
    private int remove(int v) {
      int e = dcel.outEdge(v);
      for (int tried = 0; dcel.degree(v) > 3 && tried < dcel.degree(v); tried++) {
        int following = dcel.rotate(e);
        if (isStrictlyConvex(e)) {
          suspectQuadrilateral(e);
          dcel.flip(e);
          tried = -1;
        }
        e = following;
      }
      int opposite = dcel.degree(v) == 3 ? mergeTriangles(e) : mergeQuadrilaterals(e);
      makeDelaunay();
      return opposite;
    }

    private int mergeTriangles(int x0) {
      assertThat(dcel.canRemoveVertex(x0)).isTrue();
      int e = dcel.removeVertex(x0);
      suspect(e, dcel.next(e), dcel.prev(e));
      return e;
    }

    /** The vertex is where the diagonals of its four neighbours cross. */
    private int mergeQuadrilaterals(int e) {
      assertThat(dcel.degree(dcel.origin(e))).isEqualTo(4);
      int along = dcel.rotate(e);
      dcel.joinFaces(e);
      dcel.joinFaces(dcel.rotate(along));
      assertThat(dcel.canJoinEdges(along)).isTrue();
      int joined = dcel.joinEdges(along);
      suspectQuadrilateral(joined);
      suspect(joined);
      return joined;
    }

    /** A half-edge of the triangle with v in it, or on the edge of that half-edge itself. */
    private int locate(int start, int v) {
      int e = dcel.face(start) == Dcel.OUTER ? start ^ 1 : start;
      for (int k = 0; k < 3; k++) {
        if (orient(dcel.origin(e), dcel.target(e), v) < 0) {
          return locate(dcel.next(e ^ 1), v);
        }
        e = dcel.next(e);
      }
      for (int k = 0; k < 3 && orient(dcel.origin(e), dcel.target(e), v) != 0; k++) {
        e = dcel.next(e);
      }
      return e;
    }

    private void insert(int v, int e) {
      if (orient(dcel.origin(e), dcel.target(e), v) != 0) {
        assertThat(dcel.canInsertVertex(e, v)).isTrue();
        suspect(e, dcel.next(e), dcel.prev(e));
        dcel.insertVertex(e, v);
      } else {
        suspectQuadrilateral(e);
        int d = dcel.splitEdge(e, v);
        dcel.splitFace(d, dcel.prev(e));
        dcel.splitFace(e ^ 1, dcel.prev(d ^ 1));
      }
      makeDelaunay();
    }

    private void suspectQuadrilateral(int e) {
      suspect(dcel.next(e), dcel.prev(e), dcel.next(e ^ 1), dcel.prev(e ^ 1));
    }

    private void suspect(int... halfEdges) {
      for (int e : halfEdges) {
        suspects.push(e);
      }
    }

    /** Flips until every suspect is Delaunay (Lawson 1977). */
    private void makeDelaunay() {
      while (!suspects.isEmpty()) {
        int e = suspects.pop();
        if (dcel.hasEdge(e >> 1) && isIllegal(e)) {
          suspectQuadrilateral(e);
          dcel.flip(e);
        }
      }
    }

    int illegalEdges() {
      int count = 0;
      for (int edge = 0; edge < dcel.edgeBound(); edge++) {
        count += dcel.hasEdge(edge) && isIllegal(2 * edge) ? 1 : 0;
      }
      return count;
    }

    private boolean isIllegal(int e) {
      int a = dcel.origin(e);
      int b = dcel.target(e);
      int c = left(e);
      int d = left(e ^ 1);
      return isStrictlyConvex(e)
          && Predicates.inCircle(x[a], y[a], x[b], y[b], x[c], y[c], x[d], y[d]) > 0;
    }

    private boolean isStrictlyConvex(int e) {
      return dcel.canFlip(e)
          && orient(left(e ^ 1), dcel.target(e), left(e)) > 0
          && orient(left(e), dcel.origin(e), left(e ^ 1)) > 0;
    }

    private int left(int e) {
      return dcel.origin(dcel.prev(e));
    }

    private int orient(int a, int b, int c) {
      return Predicates.orient(x[a], y[a], x[b], y[b], x[c], y[c]);
    }

    Set<String> edges() {
      return edges(dcel);
    }

    Set<String> newEdges() {
      return edges(newTriangulation().dcel());
    }

    private static Set<String> edges(Dcel dcel) {
      Set<String> edges = new TreeSet<>();
      for (int edge = 0; edge < dcel.edgeBound(); edge++) {
        int a = dcel.origin(2 * edge);
        int b = dcel.target(2 * edge);
        edges.add(Math.min(a, b) + "–" + Math.max(a, b));
      }
      return edges;
    }
  }
}
