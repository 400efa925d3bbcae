package dct.core.dcel;

import dct.core.Progress;
import java.util.Arrays;

/**
 * A doubly connected edge list: the topology of a plane subdivision, without coordinates (Muller
 * and Preparata 1978; thesis, Section 3.2.1).
 *
 * <p>Vertices, half-edges and faces are ints. Half-edge {@code e} runs from {@code origin(e)} to
 * {@code target(e)} with {@code face(e)} on its left; its twin is {@code e ^ 1}, its edge {@code e
 * >> 1}. Face 0 is the outer face, all that lies outside: where there are holes it has a cycle for
 * each besides the one round everything. Around an inner face {@code next} runs counter-clockwise;
 * {@link #rotate} goes to the next half-edge counter-clockwise around the origin.
 *
 * <p>The operators come in inverse pairs: {@code joinFaces(splitFace(a, b)) == a}; {@code
 * removeVertex(insertVertex(e, v)) == e}; {@code joinEdges(splitEdge(e, v)) == e}; {@code flip}
 * twice restores the edge, four times the half-edge. Each has a guard that says whether it applies;
 * calling an operator whose guard is false is an error of the caller. After {@link #freeze} every
 * operator throws. {@link DcelValidator} checks the laws.
 *
 * <p>Space: 16 bytes a half-edge, 8 a vertex, 4 a face.
 */
public final class Dcel {
  /** The outer face. */
  public static final int OUTER = 0;

  /** In place of a handle: there is none. */
  public static final int NONE = HalfEdges.NONE;

  final int[] outEdge; // a half-edge that leaves the vertex; NONE if it has no edge
  final int[] degree; // the number of half-edges that leave the vertex
  private final HalfEdges links;
  int[] next; // this and the following two are the arrays of the links, at hand
  int[] prev;
  int[] origin;
  int[] face; // the face on the left of e
  int[] faceEdge; // a half-edge whose left face it is; NONE where the face was removed
  private final FreeList faces;
  private boolean frozen;

  /** Without faces yet. */
  private Dcel(int vertices, HalfEdges links) {
    outEdge = new int[vertices];
    degree = new int[vertices];
    Arrays.fill(outEdge, NONE);
    this.links = links;
    readLinks();
    face = new int[2 * links.room()];
    faces = new FreeList();
  }

  private Dcel(Dcel that) {
    outEdge = that.outEdge.clone();
    degree = that.degree.clone();
    links = that.links.copy(that.links.room());
    readLinks();
    face = that.face.clone();
    faceEdge = that.faceEdge.clone();
    faces = new FreeList(that.faces);
  }

  /**
   * One cycle through n ≥ 3 different vertices: half-edge 2k runs from {@code walk[k]} to the next
   * one with the inner face 1 on its left. There is room for the 2n − 3 edges of a triangulation.
   *
   * @param walk the vertices 0 … n−1, counter-clockwise
   */
  public static Dcel cycle(int... walk) {
    int n = walk.length;
    Dcel dcel = new Dcel(n, new HalfEdges(n, 2 * n - 3));
    dcel.faceEdge = new int[n - 1];
    dcel.faceEdge[OUTER] = 1;
    dcel.faces.take();
    int inner = dcel.faces.take();
    for (int k = 0; k < n; k++) {
      int following = k + 1 == n ? 0 : k + 1;
      dcel.links.link(2 * k, 2 * following);
      dcel.links.link(2 * following + 1, 2 * k + 1);
      dcel.origin[2 * k] = walk[k];
      dcel.origin[2 * k + 1] = walk[following];
      dcel.face[2 * k] = inner;
      dcel.outEdge[walk[k]] = 2 * k;
      dcel.degree[walk[k]] = 2;
    }
    return dcel;
  }

  /**
   * The subdivision with these half-edges, in linear time. Edges that are not in use are left out;
   * the last edges take their numbers, and all others keep theirs. Faces are found by walking.
   *
   * <p>The links become those of the subdivision: the caller must not use them again.
   *
   * @param vertices the number of vertices; one without an edge stays isolated
   * @param links the half-edges
   * @param outer a half-edge of the outer face; of no account if there are no edges, and the whole
   *     plane is the outer face
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Dcel of(int vertices, HalfEdges links, int outer, Progress progress) {
    return of(vertices, links, new int[] {outer}, progress);
  }

  /**
   * The same with several cycles that count as the outer face: that round everything, and those of
   * the holes.
   *
   * @param outer a half-edge of each of these cycles, the one round everything first
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Dcel of(int vertices, HalfEdges links, int[] outer, Progress progress) {
    int[] starts = links.closeGaps(outer);
    Dcel dcel = new Dcel(vertices, links);
    for (int e = 0; e < 2 * links.bound(); e++) {
      Progress.check(progress, e);
      dcel.outEdge[dcel.origin[e]] = e;
      dcel.degree[dcel.origin[e]]++;
    }
    dcel.findFaces(links.bound() == 0 ? new int[0] : starts, progress);
    return dcel;
  }

  /**
   * Numbers the faces by their smallest half-edges. Those of triangles are chosen without a branch,
   * since every third guess of the processor would be wrong; other faces are walked.
   */
  private void findFaces(int[] outer, Progress progress) {
    int components = 1;
    int bound = links.bound();
    faceEdge = new int[2 + components + bound - Math.min(bound, degree.length)];
    faceEdge[OUTER] = outer.length == 0 ? NONE : outer[0];
    int count = 1;
    for (int e : outer) {
      relabel(e, NONE);
    }
    for (int e = 0; e < 2 * bound; e++) {
      Progress.check(progress, e);
      if (face[e] == NONE) {
        continue; // walked before
      }
      int a = next[e];
      int b = prev[e];
      if (count == faceEdge.length) {
        faceEdge = Arrays.copyOf(faceEdge, 2 * count); // more than one component
      }
      faceEdge[count] = e;
      if (next[a] == b) {
        count += ((e - a) & (e - b)) >>> 31; // 1 if e < a and e < b
      } else {
        relabel(e, NONE);
        count++;
      }
    }
    faces.take(count);
    for (int e : outer) {
      relabel(e, OUTER);
    }
    for (int f = 1; f < count; f++) {
      Progress.check(progress, f);
      relabel(faceEdge[f], f);
    }
  }

  /** A copy of the half-edges, without faces. */
  public HalfEdges links() {
    return links.copy(links.bound());
  }

  /** A copy that can be changed, also if this one is frozen. */
  public Dcel copy() {
    return new Dcel(this);
  }

  /** Forbids every further change; returns this. */
  public Dcel freeze() {
    frozen = true;
    return this;
  }

  private void checkNotFrozen() {
    if (frozen) {
      throw new IllegalStateException("this subdivision is frozen; change a copy() of it");
    }
  }

  // ---- reading

  /** The number of vertices, isolated ones included. */
  public int vertexCount() {
    return outEdge.length;
  }

  /** The number of edges. */
  public int edgeCount() {
    return links.size();
  }

  /** The number of faces, the outer one included. */
  public int faceCount() {
    return faces.size();
  }

  /**
   * Edges are numbered below this; those that were removed keep their number until it is reused.
   */
  public int edgeBound() {
    return links.bound();
  }

  /** Faces are numbered below this; those that were removed keep their number until reused. */
  public int faceBound() {
    return faces.bound();
  }

  /** Whether the edge with this number exists: it may have been removed. */
  public boolean hasEdge(int edge) {
    return links.has(edge);
  }

  /** Whether the face with this number exists: it may have been removed. */
  public boolean hasFace(int f) {
    return faceEdge[f] != NONE;
  }

  /** The half-edge after e around its left face. */
  public int next(int e) {
    return next[e];
  }

  /** The half-edge before e around its left face. */
  public int prev(int e) {
    return prev[e];
  }

  /** The same edge in the other direction. */
  public static int twin(int e) {
    return e ^ 1;
  }

  /** The vertex that e leaves. */
  public int origin(int e) {
    return origin[e];
  }

  /** The vertex that e reaches. */
  public int target(int e) {
    return origin[e ^ 1];
  }

  /** The face on the left of e. */
  public int face(int e) {
    return face[e];
  }

  /** A half-edge with this face on its left. */
  public int faceEdge(int f) {
    return faceEdge[f];
  }

  /** A half-edge that leaves v, or {@link #NONE}. */
  public int outEdge(int v) {
    return outEdge[v];
  }

  /** The number of edges at v. */
  public int degree(int v) {
    return degree[v];
  }

  /** The next half-edge counter-clockwise around the origin of e. */
  public int rotate(int e) {
    return prev[e] ^ 1;
  }

  /**
   * The half-edge from u to v, or {@link #NONE}; in as many steps as the one with fewer edges has.
   */
  public int halfEdge(int u, int v) {
    if (degree[u] > degree[v]) {
      int back = halfEdge(v, u);
      return back == NONE ? NONE : back ^ 1;
    }
    int e = outEdge[u];
    for (int k = 0; k < degree[u]; k++) {
      if (target(e) == v) {
        return e;
      }
      e = rotate(e);
    }
    return NONE;
  }

  /**
   * A half-edge of each cycle of the outer face, the one round everything first, then by their
   * smallest half-edges; in linear time.
   */
  public int[] outerCycles() {
    int[] starts = new int[4];
    int count = 0;
    boolean[] seen = new boolean[2 * links.bound()];
    for (int k = -1; k < seen.length; k++) {
      int start = k < 0 ? faceEdge[OUTER] : k;
      if (start == NONE || face[start] != OUTER || seen[start] || !links.has(start >> 1)) {
        continue;
      }
      if (count == starts.length) {
        starts = Arrays.copyOf(starts, 2 * count);
      }
      starts[count++] = start;
      int e = start;
      do {
        seen[e] = true;
        e = next[e];
      } while (e != start);
    }
    return Arrays.copyOf(starts, count);
  }

  /** Whether the edge borders the outer face. */
  public boolean isBoundary(int edge) {
    return face[2 * edge] == OUTER || face[2 * edge + 1] == OUTER;
  }

  /** Whether the left face of e has three edges. */
  public boolean isTriangle(int e) {
    return next[next[next[e]]] == e && next[next[e]] != e;
  }

  // ---- operators

  /** Whether {@link #splitFace} applies: two half-edges, not neighbours, of one inner face. */
  public boolean canSplit(int a, int b) {
    return a != b
        && face[a] == face[b]
        && face[a] != OUTER
        && next[a] != b
        && next[b] != a
        && origin(a) != origin(b);
  }

  /**
   * Cuts the left face of a and b by a new edge from the origin of a to the origin of b, as in
   * {@link HalfEdges#connect}.
   *
   * <p>The left face of the new half-edge keeps b and loses a. The side with fewer edges gets the
   * new face; both are walked in lock-step, so that the cost is the length of the shorter one.
   *
   * @return the new half-edge, from the origin of a to that of b
   */
  public int splitFace(int a, int b) {
    checkNotFrozen();
    int old = face[a];
    int d = links.connect(newEdge(), a, b);
    degree[origin(a)]++;
    degree[origin(b)]++;
    int shorter = isShorter(d, d ^ 1) ? d : d ^ 1;
    relabel(shorter, newFace(shorter));
    label(shorter ^ 1, old);
    return d;
  }

  /** Whether {@link #joinFaces} applies: e has two different inner faces on its sides. */
  public boolean canJoin(int e) {
    return face[e] != face[e ^ 1] && face[e] != OUTER && face[e ^ 1] != OUTER;
  }

  /**
   * Removes e, and with it the shorter of its two faces: the inverse of {@link #splitFace}.
   *
   * @return the half-edge after the twin of e, which now follows what came before e
   */
  public int joinFaces(int e) {
    checkNotFrozen();
    int a = next[e ^ 1];
    int shorter = isShorter(e, e ^ 1) ? e : e ^ 1;
    int removed = face[shorter];
    int kept = face[shorter ^ 1];
    relabel(shorter, kept);
    faceEdge[kept] = a;
    detach(origin(e), a);
    detach(target(e), next[e]);
    links.remove(e);
    links.give(e);
    freeFace(removed);
    return a;
  }

  private void detach(int v, int otherOutEdge) {
    degree[v]--;
    outEdge[v] = otherOutEdge;
  }

  /** Whether {@link #flip} applies to the topology: e has a triangle on each side. */
  public boolean canFlip(int e) {
    return face[e] != face[e ^ 1]
        && face[e] != OUTER
        && face[e ^ 1] != OUTER
        && isTriangle(e)
        && isTriangle(e ^ 1)
        && origin(prev(e)) != origin(prev(e ^ 1));
  }

  /**
   * Turns e counter-clockwise inside the quadrilateral of its two triangles: {@link
   * HalfEdges#flip}.
   */
  public void flip(int e) {
    checkNotFrozen();
    int t = e ^ 1;
    int bc = next[e];
    int ad = next[t];
    detach(origin(e), ad);
    detach(origin(t), bc);
    links.flip(e);
    degree[origin(e)]++;
    degree[origin(t)]++;
    int left = face[e];
    int right = face[t];
    face[ad] = left;
    face[bc] = right;
    faceEdge[left] = e;
    faceEdge[right] = t;
  }

  /** Whether {@link #insertVertex} applies: v has no edge, and e an inner triangle on its left. */
  public boolean canInsertVertex(int e, int v) {
    return degree[v] == 0 && face[e] != OUTER && isTriangle(e);
  }

  /**
   * Joins vertex v, which lies in the left triangle of e, to its three corners.
   *
   * <pre>
   *            c                         c
   *          ↙   ↖                     ↙ ↑ ↖
   *        g       f                 g   z   f
   *       ↙         ↖       →       ↙    │    ↖
   *      ↙           ↖             ↙   ↙ v ↘   ↖
   *     ↙             ↖           ↙ x         y ↖
   *    a ───── e ────→ b         a ───── e ────→ b
   * </pre>
   *
   * The triangle of e keeps its face.
   *
   * @return x, which leaves v and which e follows
   */
  public int insertVertex(int e, int v) {
    checkNotFrozen();
    int f = next[e];
    int g = prev[e];
    int x = links.hang(newEdge(), v, e);
    int y = links.connect(newEdge(), x, f);
    links.connect(newEdge(), y, g); // z
    faceEdge[face[e]] = e;
    relabel(e, face[e]);
    relabel(f, newFace(f));
    relabel(g, newFace(g));
    attach(v, x, 3);
    degree[origin(e)]++;
    degree[origin(f)]++;
    degree[origin(g)]++;
    return x;
  }

  /** Whether {@link #removeVertex} applies: the origin of x has three triangles round it. */
  public boolean canRemoveVertex(int x) {
    int y = rotate(x);
    int z = rotate(y);
    return degree(origin(x)) == 3 && isInnerTriangle(x) && isInnerTriangle(y) && isInnerTriangle(z);
  }

  private boolean isInnerTriangle(int e) {
    return face[e] != OUTER && isTriangle(e);
  }

  /**
   * Makes one triangle of the three at the origin of x, which has no edge then: undoes {@link
   * #insertVertex}, {@code removeVertex(insertVertex(e, v)) == e}.
   *
   * @return the half-edge after x, whose left face is the triangle that stays
   */
  public int removeVertex(int x) {
    checkNotFrozen();
    int e = next[x];
    int y = rotate(x);
    int z = rotate(y);
    int f = next[y];
    int g = next[z];
    detach(origin(e), e);
    detach(origin(f), f);
    detach(origin(g), g);
    attach(origin(x), NONE, 0);
    freeFace(face[g]);
    freeFace(face[f]);
    links.remove(z);
    links.remove(y);
    links.unhang(x);
    links.give(z);
    links.give(y);
    links.give(x);
    faceEdge[face[e]] = e;
    relabel(e, face[e]);
    return e;
  }

  /** Whether {@link #splitEdge} applies: v has no edge. */
  public boolean canSplitEdge(int e, int v) {
    return hasEdge(e >> 1) && degree[v] == 0;
  }

  /**
   * Puts vertex v, which has no edge, into the edge of e: {@link HalfEdges#split}. The faces on
   * both sides get a vertex more.
   *
   * @return the new half-edge, from v to what was the target of e
   */
  public int splitEdge(int e, int v) {
    checkNotFrozen();
    int b = target(e);
    int d = links.split(newEdge(), e, v);
    face[d] = face[e];
    face[d ^ 1] = face[e ^ 1];
    outEdge[b] = d ^ 1;
    attach(v, d, 2);
    return d;
  }

  /** Whether {@link #joinEdges} applies: the origin of d has two edges, to different vertices. */
  public boolean canJoinEdges(int d) {
    return degree(origin(d)) == 2 && target(d) != origin(prev(d));
  }

  /**
   * Makes one edge of the two at the origin of d, which has no edge then: undoes {@link
   * #splitEdge}, {@code joinEdges(splitEdge(e, v)) == e}.
   *
   * @return the half-edge before d, which reaches now what d reached
   */
  public int joinEdges(int d) {
    checkNotFrozen();
    int e = prev[d];
    attach(origin(d), NONE, 0);
    links.join(d);
    links.give(d);
    outEdge[target(e)] = e ^ 1;
    label(e, face[e]);
    label(e ^ 1, face[e ^ 1]);
    return e;
  }

  private void attach(int v, int out, int edges) {
    outEdge[v] = out;
    degree[v] = edges;
  }

  private boolean isShorter(int e, int f) {
    int x = next[e];
    int y = next[f];
    while (x != e && y != f) {
      x = next[x];
      y = next[y];
    }
    return x == e;
  }

  private void relabel(int start, int label) {
    int e = start;
    do {
      face[e] = label;
      e = next[e];
    } while (e != start);
  }

  private void label(int e, int f) {
    face[e] = f;
    faceEdge[f] = e;
  }

  private void readLinks() {
    next = links.next;
    prev = links.prev;
    origin = links.origin;
  }

  private int newEdge() {
    int e = links.take();
    if (e >= face.length) {
      readLinks();
      face = Arrays.copyOf(face, 2 * links.room());
    }
    return e;
  }

  /** A new face, with e on its border. */
  private int newFace(int e) {
    int f = faces.take();
    if (f >= faceEdge.length) {
      faceEdge = Arrays.copyOf(faceEdge, Math.max(4, f + f / 2));
    }
    faceEdge[f] = e;
    return f;
  }

  private void freeFace(int f) {
    faceEdge[f] = NONE;
    faces.give(f);
  }
}
