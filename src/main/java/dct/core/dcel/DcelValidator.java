package dct.core.dcel;

import java.util.Arrays;
import java.util.function.IntConsumer;

/** The laws of a {@link Dcel}, checked in an order in which each may rely on those before it. */
public final class DcelValidator {
  private final Dcel dcel;

  private DcelValidator(Dcel dcel) {
    this.dcel = dcel;
  }

  /**
   * Checks every law of the structure, in linear time.
   *
   * @throws IllegalStateException naming the first broken law and the handle that breaks it
   */
  public static void validate(Dcel dcel) {
    new DcelValidator(dcel).validate();
  }

  private void validate() {
    forEachHalfEdge(this::checkHandles);
    forEachHalfEdge(this::checkLinks);
    checkVertices();
    checkFaces();
    checkEuler();
  }

  private void forEachHalfEdge(IntConsumer check) {
    for (int e = 0; e < 2 * dcel.edgeBound(); e++) {
      if (dcel.hasEdge(e >> 1)) {
        check.accept(e);
      }
    }
  }

  private void checkHandles(int e) {
    require(isUsed(dcel.next[e]), "next in range", "half-edge", e);
    require(isUsed(dcel.prev[e]), "prev in range", "half-edge", e);
    require(inRange(dcel.origin[e], dcel.vertexCount()), "origin in range", "half-edge", e);
    require(
        inRange(dcel.face[e], dcel.faceBound()) && dcel.hasFace(dcel.face[e]),
        "face in range",
        "half-edge",
        e);
  }

  private boolean isUsed(int e) {
    return inRange(e, 2 * dcel.edgeBound()) && dcel.hasEdge(e >> 1);
  }

  private static boolean inRange(int handle, int bound) {
    return handle >= 0 && handle < bound;
  }

  private void checkLinks(int e) {
    require(dcel.prev[dcel.next[e]] == e, "prev(next(e)) = e", "half-edge", e);
    require(dcel.next[dcel.prev[e]] == e, "next(prev(e)) = e", "half-edge", e);
    require(
        dcel.origin[dcel.next[e]] == dcel.target(e), "origin(next(e)) = target(e)", "half-edge", e);
    require(dcel.face[dcel.next[e]] == dcel.face[e], "face(next(e)) = face(e)", "half-edge", e);
  }

  /** The half-edges that leave a vertex are one turn of {@code rotate}, and degree counts them. */
  private void checkVertices() {
    int[] leaving = new int[dcel.vertexCount()];
    forEachHalfEdge(e -> leaving[dcel.origin[e]]++);
    for (int v = 0; v < dcel.vertexCount(); v++) {
      require(dcel.degree[v] == leaving[v], "degree(v) counts the edges at v", "vertex", v);
      int out = dcel.outEdge[v];
      require((out == Dcel.NONE) == (leaving[v] == 0), "outEdge(v) exists", "vertex", v);
      if (out != Dcel.NONE) {
        require(isUsed(out) && dcel.origin[out] == v, "origin(outEdge(v)) = v", "vertex", v);
        require(turnLength(out) == leaving[v], "one turn around v", "vertex", v);
      }
    }
  }

  private int turnLength(int start) {
    int length = 0;
    int e = start;
    do {
      length++;
      e = dcel.rotate(e);
    } while (e != start);
    return length;
  }

  /** The half-edges labelled with a face are one cycle of {@code next}; of the outer face, some. */
  private void checkFaces() {
    int[] labelled = new int[dcel.faceBound()];
    forEachHalfEdge(e -> labelled[dcel.face[e]]++);
    for (int f = 0; f < dcel.faceBound(); f++) {
      if (dcel.hasFace(f) && dcel.edgeCount() > 0) {
        int start = dcel.faceEdge[f];
        require(isUsed(start) && dcel.face[start] == f, "face(faceEdge(f)) = f", "face", f);
        int length = f == Dcel.OUTER ? outerLength() : cycleLength(start);
        require(length == labelled[f], "one cycle around f", "face", f);
      }
    }
  }

  private int outerLength() {
    return Arrays.stream(dcel.outerCycles()).map(this::cycleLength).sum();
  }

  private int cycleLength(int start) {
    int length = 0;
    int e = start;
    do {
      length++;
      e = dcel.next[e];
    } while (e != start);
    return length;
  }

  /** For a connected subdivision, vertices − edges + faces = 2; every cycle outside is a face. */
  private void checkEuler() {
    int vertices = 0;
    for (int out : dcel.outEdge) {
      if (out != Dcel.NONE) {
        vertices++;
      }
    }
    int holes = Math.max(0, dcel.outerCycles().length - 1);
    int sum = vertices - dcel.edgeCount() + dcel.faceCount() + holes;
    require(vertices == 0 || sum == 2, "vertices − edges + faces = 2", "sum", sum);
  }

  private static void require(boolean holds, String law, String what, int handle) {
    if (!holds) {
      throw new IllegalStateException("broken law: " + law + " (at " + what + " " + handle + ")");
    }
  }
}
