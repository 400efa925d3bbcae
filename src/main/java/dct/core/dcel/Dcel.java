package dct.core.dcel;

import java.util.Arrays;

/**
 * A doubly connected edge list: the topology of a plane subdivision, without coordinates (Muller
 * and Preparata 1978; thesis, Section 3.2.1).
 *
 * <p>Vertices, half-edges and faces are ints. Half-edge {@code e} runs from {@code origin(e)} to
 * {@code target(e)} with {@code face(e)} on its left; its twin is {@code e ^ 1}, its edge {@code e
 * >> 1}. Face 0 is the outer face. Around an inner face {@code next} runs counter-clockwise; {@link
 * #rotate} goes to the next half-edge counter-clockwise around the origin.
 *
 * <p>The operators come in inverse pairs: {@code joinFaces(splitFace(a, b)) == a}; {@code flip}
 * twice restores the edge, four times the half-edge. Each has a guard that says whether it applies;
 * calling an operator whose guard is false is an error of the caller. After {@link #freeze} every
 * operator throws. {@link #validate} checks the laws.
 *
 * <p>Space: 16 bytes a half-edge, 8 a vertex, 4 a face.
 */
public final class Dcel {
  /** The outer face. */
  public static final int OUTER = 0;

  /** In place of a handle: there is none. */
  public static final int NONE = -1;

  final int[] outEdge; // a half-edge that leaves the vertex; NONE if it has no edge
  final int[] degree; // the number of half-edges that leave the vertex
  int[] next; // the half-edge after e around its left face; NONE where the edge was removed
  int[] prev; // the half-edge before e around its left face
  int[] origin; // the vertex that e leaves
  int[] face; // the face on the left of e
  int[] faceEdge; // a half-edge whose left face it is; NONE where the face was removed
  private final FreeList edges;
  private final FreeList faces;
  private boolean frozen;

  private Dcel(int vertices, int edgeCapacity, int faceCapacity) {
    outEdge = new int[vertices];
    degree = new int[vertices];
    Arrays.fill(outEdge, NONE);
    next = new int[2 * edgeCapacity];
    prev = new int[2 * edgeCapacity];
    origin = new int[2 * edgeCapacity];
    face = new int[2 * edgeCapacity];
    faceEdge = new int[faceCapacity];
    edges = new FreeList();
    faces = new FreeList();
  }

  /** Without faces yet, and without a look at the arrays. */
  private Dcel(int vertices, int[] next, int[] prev, int[] origin) {
    outEdge = new int[vertices];
    degree = new int[vertices];
    Arrays.fill(outEdge, NONE);
    this.next = next;
    this.prev = prev;
    this.origin = origin;
    face = new int[next.length];
    edges = new FreeList();
    faces = new FreeList();
  }

  private Dcel(Dcel that) {
    outEdge = that.outEdge.clone();
    degree = that.degree.clone();
    next = that.next.clone();
    prev = that.prev.clone();
    origin = that.origin.clone();
    face = that.face.clone();
    faceEdge = that.faceEdge.clone();
    edges = new FreeList(that.edges);
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
    Dcel dcel = new Dcel(n, 2 * n - 3, n - 1);
    dcel.faces.take(); // the outer one
    int inner = dcel.faces.take();
    for (int k = 0; k < n; k++) {
      dcel.edges.take();
      dcel.set(2 * k, walk[k], 2 * ((k + 1) % n), 2 * ((k + n - 1) % n), inner);
      int back = 2 * ((k + n - 1) % n) + 1;
      dcel.set(2 * k + 1, walk[(k + 1) % n], back, 2 * ((k + 1) % n) + 1, OUTER);
      dcel.outEdge[walk[k]] = 2 * k;
      dcel.degree[walk[k]] = 2;
    }
    dcel.faceEdge[inner] = 0;
    dcel.faceEdge[OUTER] = 1;
    return dcel;
  }

  private void set(int e, int from, int following, int preceding, int left) {
    origin[e] = from;
    next[e] = following;
    prev[e] = preceding;
    face[e] = left;
  }

  /**
   * The subdivision with these half-edges, in linear time. Edges whose {@code next} is {@link
   * #NONE} are left out; the last edges take their numbers, and all others keep theirs. Faces are
   * found by walking.
   *
   * <p>The arrays become those of the subdivision: the caller must not use them again.
   *
   * @param vertices the number of vertices; one without an edge stays isolated
   * @param next the half-edge after each one around its left face
   * @param prev the half-edge before each one
   * @param origin the vertex that each one leaves
   * @param outer a half-edge of the outer face; of no account if there are no edges, and the whole
   *     plane is the outer face
   */
  public static Dcel of(int vertices, int[] next, int[] prev, int[] origin, int outer) {
    Dcel dcel = new Dcel(vertices, next, prev, origin);
    int start = dcel.closeGaps(outer);
    for (int e = 0; e < 2 * dcel.edges.bound(); e++) {
      dcel.outEdge[origin[e]] = e;
      dcel.degree[origin[e]]++;
    }
    dcel.findFaces(dcel.edges.bound() == 0 ? NONE : start);
    return dcel;
  }

  /** Gives the numbers of missing edges to the last ones; returns where {@code watched} went. */
  private int closeGaps(int watched) {
    int end = next.length;
    int moved = watched;
    for (int e = 0; e < end; e += 2) {
      while (e < end && next[e] == NONE) {
        end -= 2;
        if (e < end && next[end] != NONE) {
          rename(end, e);
          moved = (moved & ~1) == end ? e | (moved & 1) : moved;
        }
      }
    }
    edges.take(end / 2);
    return moved;
  }

  /** Gives an edge, by its even half-edge, the number of one that is missing. */
  private void rename(int from, int to) {
    for (int side = 0; side < 2; side++) {
      next[to + side] = next[from + side];
      prev[to + side] = prev[from + side];
      origin[to + side] = origin[from + side];
    }
    for (int side = 0; side < 2; side++) {
      // An end without another edge links the edge with itself.
      int following = next[to + side];
      int preceding = prev[to + side];
      link(to + side, (following & ~1) == from ? to | (following & 1) : following);
      link((preceding & ~1) == from ? to | (preceding & 1) : preceding, to + side);
    }
  }

  /**
   * Numbers the faces by their smallest half-edges. Those of triangles are chosen without a branch,
   * since every third guess of the processor would be wrong; other faces are walked.
   */
  private void findFaces(int outer) {
    int components = 1;
    faceEdge = new int[2 + components + edges.bound() - Math.min(edges.bound(), degree.length)];
    faceEdge[OUTER] = outer;
    int count = 1;
    if (outer != NONE) {
      relabel(outer, NONE);
    }
    for (int e = 0; e < 2 * edges.bound(); e++) {
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
    for (int f = outer == NONE ? 1 : 0; f < count; f++) {
      relabel(faceEdge[f], f);
    }
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
    return edges.size();
  }

  /** The number of faces, the outer one included. */
  public int faceCount() {
    return faces.size();
  }

  /**
   * Edges are numbered below this; those that were removed keep their number until it is reused.
   */
  public int edgeBound() {
    return edges.bound();
  }

  /** Faces are numbered below this; those that were removed keep their number until reused. */
  public int faceBound() {
    return faces.bound();
  }

  /** Whether the edge with this number exists: it may have been removed. */
  public boolean hasEdge(int edge) {
    return next[2 * edge] != NONE;
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
        && origin[a] != origin[b];
  }

  /**
   * Cuts the left face of a and b by a new edge from the origin of a to the origin of b.
   *
   * <pre>
   *      ←──── ·            b's origin ───→ b
   *      pb ↗                 ↑ │
   *                         d │ │ twin(d)
   *                           │ ↓
   *      a ←──── a's origin ←──── pa
   * </pre>
   *
   * The left face of d keeps b and loses a. The side with fewer edges gets the new face; both are
   * walked in lock-step, so that the cost is the length of the shorter one.
   *
   * @return d, the new half-edge from the origin of a to that of b
   */
  public int splitFace(int a, int b) {
    checkNotFrozen();
    int pa = prev[a];
    int pb = prev[b];
    int d = newEdge();
    int t = d ^ 1;
    origin[d] = origin[a];
    origin[t] = origin[b];
    link(pa, d);
    link(d, b);
    link(pb, t);
    link(t, a);
    degree[origin[a]]++;
    degree[origin[b]]++;
    int old = face[a];
    int added = newFace();
    boolean dIsShort = isShorter(d, t);
    int shorter = dIsShort ? d : t;
    relabel(shorter, added);
    faceEdge[added] = shorter;
    face[shorter ^ 1] = old;
    faceEdge[old] = shorter ^ 1;
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
    int t = e ^ 1;
    int a = next[t];
    int b = next[e];
    int shorter = isShorter(e, t) ? e : t;
    int removed = face[shorter];
    int kept = face[shorter ^ 1];
    relabel(shorter, kept);
    faceEdge[kept] = a;
    link(prev[e], a);
    link(prev[t], b);
    detach(origin[e], a);
    detach(origin[t], b);
    next[e] = NONE;
    next[t] = NONE;
    edges.give(e >> 1);
    faceEdge[removed] = NONE;
    faces.give(removed);
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
        && origin[prev[e]] != origin[prev[e ^ 1]];
  }

  /**
   * Turns e counter-clockwise inside the quadrilateral of its two triangles.
   *
   * <pre>
   *          c                      c
   *        ↙   ↖                  ↙ ↑ ↖
   *     ca       bc             ca  │   bc
   *    ↙           ↖           ↙    │     ↖
   *   a ─── e ────→ b    →    a     e      b
   *    ↘           ↗           ↘    │     ↗
   *     ad       db             ad  │   db
   *        ↘   ↗                  ↘ │ ↗
   *          d                      d
   * </pre>
   */
  public void flip(int e) {
    checkNotFrozen();
    int t = e ^ 1;
    int bc = next[e];
    int ca = prev[e];
    int ad = next[t];
    int db = prev[t];
    int a = origin[e];
    int b = origin[t];
    int c = origin[ca];
    int d = origin[db];
    int left = face[e];
    int right = face[t];
    link(e, ca);
    link(ca, ad);
    link(ad, e);
    link(t, db);
    link(db, bc);
    link(bc, t);
    origin[e] = d;
    origin[t] = c;
    face[ad] = left;
    face[bc] = right;
    faceEdge[left] = e;
    faceEdge[right] = t;
    detach(a, ad);
    detach(b, bc);
    degree[c]++;
    degree[d]++;
  }

  private void link(int e, int following) {
    next[e] = following;
    prev[following] = e;
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

  private int newEdge() {
    int e = 2 * edges.take();
    if (e >= next.length) {
      int longer = Math.max(8, e + e / 2) & ~1;
      next = Arrays.copyOf(next, longer);
      prev = Arrays.copyOf(prev, longer);
      origin = Arrays.copyOf(origin, longer);
      face = Arrays.copyOf(face, longer);
    }
    return e;
  }

  private int newFace() {
    int f = faces.take();
    if (f >= faceEdge.length) {
      faceEdge = Arrays.copyOf(faceEdge, Math.max(4, f + f / 2));
    }
    return f;
  }

  /**
   * Checks every law of the structure, in linear time.
   *
   * @throws IllegalStateException naming the first broken law and the handle that breaks it
   */
  public void validate() {
    new DcelValidator(this).validate();
  }
}
