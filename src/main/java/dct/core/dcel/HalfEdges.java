package dct.core.dcel;

import java.util.Arrays;

/**
 * The links of a plane graph: half-edges and what follows what around a face, but no faces and no
 * coordinates. All that links half-edges stands on this: {@link Dcel} adds faces and degrees; what
 * needs neither works on it alone and makes a {@code Dcel} at the end ({@link Dcel#of}).
 *
 * <p>Half-edge {@code e} leaves {@code origin(e)}; its twin is {@code e ^ 1}, its edge {@code e >>
 * 1}. The half-edge that leaves a vertex within a face stands for that <em>corner</em> of the face.
 * An edge that is not in use has {@link #NONE} as its {@code next}.
 *
 * <p>The operators change links and origins, in constant time. Each has an inverse: {@link #remove}
 * undoes {@link #connect}, {@link #unhang} undoes {@link #hang}, {@link #join} undoes {@link
 * #split}, and four times {@link #flip} is nothing. An operator that needs an edge is given the
 * number of one that is not in use, from {@link #take} or from a {@link FreeEdges}.
 *
 * <p>Space: 12 bytes a half-edge.
 */
public final class HalfEdges {
  /** In place of a half-edge: there is none. */
  public static final int NONE = -1;

  int[] next; // the half-edge after e around its left face; NONE where the edge is not in use
  int[] prev; // the half-edge before e around its left face
  int[] origin; // the vertex that e leaves
  private final FreeEdges free = new FreeEdges();
  private int edges; // numbers below this one are in use or in the list
  private int freeCount;

  /**
   * Half-edges 0 … 2 · edges − 1, which the caller has to link, or to give to a list.
   *
   * @param edges how many edges there are at first
   * @param room for how many there is room before anything has to be copied
   */
  public HalfEdges(int edges, int room) {
    this.edges = edges;
    next = new int[2 * room];
    prev = new int[2 * room];
    origin = new int[2 * room];
  }

  /**
   * Half-edges that are linked already.
   *
   * @param next the half-edge after each one
   * @param origin the vertex that each one leaves
   */
  public static HalfEdges of(int[] next, int[] origin) {
    HalfEdges links = new HalfEdges(next.length / 2, next.length / 2);
    for (int e = 0; e < next.length; e++) {
      links.link(e, next[e]);
      links.origin[e] = origin[e];
    }
    return links;
  }

  /** A copy, with room for so many edges. */
  HalfEdges copy(int room) {
    HalfEdges copy = new HalfEdges(edges, 0);
    copy.next = Arrays.copyOf(next, 2 * room);
    copy.prev = Arrays.copyOf(prev, 2 * room);
    copy.origin = Arrays.copyOf(origin, 2 * room);
    copy.free.first = free.first;
    copy.free.last = free.last;
    copy.freeCount = freeCount;
    return copy;
  }

  /** Edges are numbered below this. */
  public int bound() {
    return edges;
  }

  /** The number of edges in use, as far as they are taken and given here. */
  int size() {
    return edges - freeCount;
  }

  /** For how many edges there is room. */
  int room() {
    return next.length / 2;
  }

  /** The array of what is after each half-edge, for loops in which every call counts. */
  public int[] next() {
    return next;
  }

  /** The array of what is before each half-edge. */
  public int[] prev() {
    return prev;
  }

  /** The array of the vertices that the half-edges leave. */
  public int[] origin() {
    return origin;
  }

  // ---- operators

  /** Makes {@code following} the half-edge after e. */
  public void link(int e, int following) {
    next[e] = following;
    prev[following] = e;
  }

  /**
   * Makes an edge between two vertices that have no other: {@code e ⇄ e ^ 1}.
   *
   * @return e
   */
  public int segment(int e, int from, int to) {
    origin[e] = from;
    origin[e ^ 1] = to;
    link(e, e ^ 1);
    link(e ^ 1, e);
    return e;
  }

  /**
   * Makes d an edge from corner a to corner b, of one face or of two.
   *
   * <pre>
   *      ←──── pb            ←──── pb
   *        b ↗                 b ↗ ↑ │
   *                    →         d │ │ t
   *        ↖ pa                 ↖  │ ↓ pa
   *      a ←────             a ←────
   * </pre>
   *
   * @return d, which b follows; a follows its twin t
   */
  public int connect(int d, int a, int b) {
    int t = d ^ 1;
    int pa = prev[a];
    int pb = prev[b];
    origin[d] = origin[a];
    origin[t] = origin[b];
    link(pa, d);
    link(d, b);
    link(pb, t);
    link(t, a);
    return d;
  }

  /** Takes d out, which must not be the last edge of a vertex: undoes {@link #connect}. */
  public void remove(int d) {
    int t = d ^ 1;
    int a = next[t];
    int b = next[d];
    int pa = prev[d];
    int pb = prev[t];
    link(pa, a);
    link(pb, b);
    next[d] = NONE;
    next[t] = NONE;
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
    int t = e ^ 1;
    int bc = next[e];
    int ca = prev[e];
    int ad = next[t];
    int db = prev[t];
    int c = origin[ca];
    int d = origin[db];
    link(e, ca);
    link(ca, ad);
    link(ad, e);
    link(t, db);
    link(db, bc);
    link(bc, t);
    origin[e] = d;
    origin[t] = c;
  }

  /**
   * Hangs vertex v, which has no edge, into corner a by the edge of d.
   *
   * <pre>
   *    a ↗                 a ↗
   *    ·             →     · ←── d ── v
   *    pa ↖                pa ↖
   * </pre>
   *
   * @return d, which leaves v and which a follows
   */
  public int hang(int d, int v, int a) {
    int t = d ^ 1;
    int pa = prev[a];
    origin[d] = v;
    origin[t] = origin[a];
    link(pa, t);
    link(t, d);
    link(d, a);
    return d;
  }

  /** Takes d out, the only edge of its origin: undoes {@link #hang}. */
  public void unhang(int d) {
    link(prev[d ^ 1], next[d]);
    next[d] = NONE;
    next[d ^ 1] = NONE;
  }

  /**
   * Puts vertex v, which has no edge, into the edge of e; the edge of d is the second part.
   *
   * <pre>
   *   a ─────── e ──────→ b    →    a ── e ──→ v ── d ──→ b
   * </pre>
   *
   * @return d
   */
  public int split(int d, int e, int v) {
    int t = e ^ 1;
    int following = next[e] == t ? d ^ 1 : next[e]; // b may have no other edge
    int preceding = prev[t] == e ? d : prev[t];
    origin[d] = v;
    origin[d ^ 1] = origin[t];
    origin[t] = v;
    link(d, following);
    link(preceding, d ^ 1);
    link(e, d);
    link(d ^ 1, t);
    return d;
  }

  /** Takes d and its origin, which has one other edge, out: undoes {@link #split}. */
  public void join(int d) {
    int e = prev[d];
    int t = e ^ 1;
    int following = next[d] == (d ^ 1) ? t : next[d];
    int preceding = prev[d ^ 1] == d ? e : prev[d ^ 1];
    origin[t] = origin[d ^ 1];
    link(e, following);
    link(preceding, t);
    next[d] = NONE;
    next[d ^ 1] = NONE;
  }

  // ---- which edges are in use

  /** Whether this edge is in use. */
  public boolean has(int edge) {
    return next[2 * edge] != NONE;
  }

  /** The even half-edge of an edge that is not in use: one given back, or else one more. */
  public int take() {
    if (free.first != NONE) {
      freeCount--;
      return take(free);
    }
    int e = 2 * edges++;
    if (e >= next.length) {
      int longer = Math.max(8, e + e / 2) & ~1;
      next = Arrays.copyOf(next, longer);
      prev = Arrays.copyOf(prev, longer);
      origin = Arrays.copyOf(origin, longer);
    }
    return e;
  }

  /** Gives back the edge of e, which is not linked any more. */
  void give(int e) {
    freeCount++;
    give(free, e);
  }

  /**
   * Edges that are not in use, linked through {@code prev}; the one given last is taken first.
   * Parts of one {@link HalfEdges} that have each their own list can be worked on by different
   * threads.
   */
  public static final class FreeEdges {
    private int first = NONE; // even half-edges
    private int last = NONE;
  }

  /** The even half-edge of an edge of this list, which must have one. */
  public int take(FreeEdges list) {
    int e = list.first;
    list.first = prev[e];
    if (list.first == NONE) {
      list.last = NONE;
    }
    return e;
  }

  /** Adds the edge of e, which is not linked any more, to the list. */
  public void give(FreeEdges list, int e) {
    int even = e & ~1;
    next[even] = NONE;
    next[even + 1] = NONE;
    prev[even] = list.first;
    list.first = even;
    if (list.last == NONE) {
      list.last = even;
    }
  }

  /** Moves the edges of {@code added} to the end of {@code list}. */
  public void append(FreeEdges list, FreeEdges added) {
    if (list.first == NONE) {
      list.first = added.first;
    } else if (added.first != NONE) {
      prev[list.last] = added.first;
    }
    if (added.first != NONE) {
      list.last = added.last;
    }
    added.first = NONE;
    added.last = NONE;
  }

  /**
   * Gives the numbers of the edges that are not in use to the last ones, and forgets every list.
   *
   * @return the numbers that the half-edges {@code watched} have then
   */
  int[] closeGaps(int... watched) {
    int end = 2 * edges;
    int[] moved = watched.clone();
    for (int e = 0; e < end; e += 2) {
      while (e < end && next[e] == NONE) {
        end -= 2;
        if (e < end && next[end] != NONE) {
          rename(end, e);
          for (int k = 0; k < moved.length; k++) {
            moved[k] = (moved[k] & ~1) == end ? e | (moved[k] & 1) : moved[k];
          }
        }
      }
    }
    edges = end / 2;
    free.first = NONE;
    free.last = NONE;
    freeCount = 0;
    return moved;
  }

  /** Gives an edge, by its even half-edge, the number of one that is not in use. */
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
}
