package dct.core.degree.strip;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.degree.region.SearchMesh;
import java.util.ArrayList;
import java.util.List;

/**
 * Triangulates a {@link Strip} anew with few unmet vertices: a beam search over the moves of a
 * sweep ({@link SweepMove}).
 *
 * <p>A state is the path that the triangles so far end at, with the parities on it. States alike in
 * both are one, which keeps the better way to it; after each move only the {@code width} states are
 * kept in which most vertices are finished and have the parity wished. As the sweep leaves nothing
 * behind but finished vertices, what cannot be mended shows at once, also on a long straight side
 * of the hull. With no limit to the width the search would be exact, that of {@link
 * dct.core.degree.exact.ExactSites} in another order.
 *
 * <p>O(w · c) states a move for a width of w and c empty triangles on an edge; the number of moves
 * is less than three times that of the triangles.
 */
final class SweepBeam {
  private final Strip strip;
  private final int width;
  private final EmptyTriangles triangles;
  private final SweepOffspring offspring;
  private final long[] onPath; // by rank and parity: its part of the key of a path that it is on
  private final long[] begins; // by rank: its part if the next edge begins there
  private SweepFronts fronts;
  private SweepFronts following;
  private final List<int[]> parents = new ArrayList<>(); // by move and state
  private final List<int[]> moves = new ArrayList<>(); // by move and state
  private int most;
  private int unmet;

  SweepBeam(Strip strip, int width, SeededRandom random) {
    this.strip = strip;
    this.width = width;
    triangles = new EmptyTriangles(strip.mesh, strip.vertices());
    offspring = new SweepOffspring(random);
    onPath = longs(2 * strip.size(), random);
    begins = longs(strip.size(), random);
    fronts = new SweepFronts(strip, width);
    following = new SweepFronts(strip, width);
  }

  private static long[] longs(int count, SeededRandom random) {
    long[] longs = new long[count];
    for (int i = 0; i < count; i++) {
      longs[i] = ((long) random.nextInt() << Integer.SIZE) ^ random.nextInt();
    }
    return longs;
  }

  /**
   * The moves of a triangulation of the strip with no more than {@code atMost} unmet vertices, or
   * none if there is none in the beam or the progress has struck.
   */
  int[] search(int atMost, Progress progress) {
    most = atMost;
    fronts.begin();
    while (fronts.size > 0 && fronts.hasNext(0)) {
      if (progress.isCancelled()) {
        return new int[0];
      }
      step();
    }
    int best = best();
    return best == SearchMesh.NONE ? new int[0] : trace(best);
  }

  /** How many vertices of the strip are unmet in the triangulation found. */
  int unmet() {
    return unmet;
  }

  private void step() {
    offspring.clear();
    for (int s = 0; s < fronts.size; s++) {
      expand(s);
    }
    int[] best = offspring.best(width);
    int[] parent = new int[best.length];
    int[] move = new int[best.length];
    following.size = 0;
    for (int i = 0; i < best.length; i++) {
      parent[i] = offspring.parent(best[i]);
      move[i] = offspring.move(best[i]);
      offspring.materialize(best[i], fronts, following);
    }
    parents.add(parent);
    moves.add(move);
    SweepFronts done = fronts;
    fronts = following;
    following = done;
  }

  private void expand(int s) {
    fronts.hasNext(s); // so that it is known
    int here = fronts.here(s);
    int next = fronts.next(s);
    int a = here >> 1;
    int b = next >> 1;
    if (strip.isUpperEdge(a, b)) {
      finish(s, SweepMove.CLOSE, here, onPath[here] ^ begins[a] ^ begins[b]);
      return;
    }
    if (fronts.hasRoom(s)) {
      int edge = triangles.edge(a, b);
      join(s, edge, turned(here) ^ turned(next));
      if (!strip.isOnUpper(b) && triangles.canWait(edge)) {
        add(s, SweepMove.WAIT, begins[a] ^ begins[b]);
      }
    }
    if (fronts.hasWaiting(s)) {
      cut(s, fronts.waiting(s), here, next);
    }
  }

  private void join(int s, int edge, long turned) {
    for (int c : triangles.apexesAbove(edge)) {
      add(s, c, turned ^ onPath[2 * c + (strip.wrongOutside(c) ^ 1)]);
    }
  }

  private void cut(int s, int waiting, int here, int next) {
    if (triangles.canCut(waiting >> 1, here >> 1, next >> 1)) {
      long left = onPath[here] ^ begins[here >> 1] ^ begins[waiting >> 1];
      finish(s, SweepMove.CUT, here ^ 1, turned(waiting) ^ turned(next) ^ left);
    }
  }

  /** How the key changes with the parity of a vertex on the path. */
  private long turned(int v) {
    return onPath[v] ^ onPath[v ^ 1];
  }

  private void add(int s, int move, long change) {
    offspring.add(s, move, fronts.unmet[s], fronts.met[s], fronts.key[s] ^ change);
  }

  /** Takes a move that finishes v. */
  private void finish(int s, int move, int v, long change) {
    int miss = (v & 1) * strip.cost(v >> 1);
    int count = fronts.unmet[s] + miss;
    if (count <= most) {
      offspring.add(s, move, count, fronts.met[s] + 1 - miss, fronts.key[s] ^ change);
    }
  }

  /** The best of the states that have come to the end, or NONE. */
  private int best() {
    int best = SearchMesh.NONE;
    unmet = most + 1;
    for (int s = 0; s < fronts.size; s++) {
      int last = fronts.here(s);
      int count = fronts.unmet[s] + (last & 1) * strip.cost(last >> 1);
      if (count < unmet) {
        best = s;
        unmet = count;
      }
    }
    return best;
  }

  private int[] trace(int last) {
    int[] trace = new int[moves.size()];
    int s = last;
    for (int i = trace.length - 1; i >= 0; i--) {
      trace[i] = moves.get(i)[s];
      s = parents.get(i)[s];
    }
    return trace;
  }
}
