package dct.core.geometry;

import dct.core.Progress;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The faces into which rings and fixed edges that do not cross divide the plane, and which of them
 * are inside: in the outer ring and in no hole, a place being in a ring if a way out of it crosses
 * the ring an odd number of times.
 *
 * <p>An <em>arc</em> leads from one place to the next along an edge; where several edges run, there
 * is one. A line sweeps over the arcs from high to low y; the faces on both sides of an arc are
 * joined with those beside it. O(n log n) expected.
 */
final class Faces {
  private static final int OUTSIDE = 0;

  private final Rings rings;
  private final Points points;
  private final Meetings meetings;
  private final Map<Long, Integer> arcOf = new HashMap<>(); // by both places
  private final List<int[]> ends = new ArrayList<>(); // by arc: the vertices, upper one first
  private final List<int[]> ringsOf = new ArrayList<>(); // by arc: as often as they pass it
  private final int[] rank; // by vertex: its place in the sweep, the lowest first
  private final int[] order;
  private int[][] round; // by vertex that stands for its place: its arcs, clockwise
  private int[] joined; // by face: one that is the same, in the end the one that stands for it
  private int[] faceOfSite; // by vertex
  private boolean[] inside; // by face

  private Faces(Rings rings, Meetings meetings, Progress progress) {
    this.rings = rings;
    this.meetings = meetings;
    points = rings.points();
    order = PlaneOrder.byYThenX(points, progress);
    rank = new int[order.length];
    for (int k = 0; k < order.length; k++) {
      rank[order[k]] = k;
    }
  }

  /**
   * The faces.
   *
   * @return nothing if a site meets anything or is not inside, a fixed edge is not inside, or a
   *     hole is not in the outer ring or is in another
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Optional<Faces> of(Rings rings, Meetings meetings, Progress progress) {
    Faces faces = new Faces(rings, meetings, progress);
    boolean isUsable =
        faces.areSitesApart()
            && faces.addArcs()
            && faces.sweep(progress)
            && faces.findInside()
            && faces.areSitesAndFixedEdgesInside();
    return isUsable ? Optional.of(faces) : Optional.empty();
  }

  private boolean areSitesApart() {
    return meetings.groups().stream().flatMapToInt(Arrays::stream).allMatch(rings::isOnRing)
        && meetings.inside().values().stream().flatMap(List::stream).allMatch(rings::isOnRing);
  }

  /** Adds the arcs of all edges; false if a fixed edge passes a vertex. */
  private boolean addArcs() {
    int n = points.size();
    for (int e = 0; e < n + rings.fixedCount(); e++) {
      boolean isFixed = e >= n;
      if (isFixed || rings.isOnRing(e)) {
        int[] along = meetings.along(e, rings.from(e), rings.to(e));
        if (isFixed && along.length > 2) {
          return false;
        }
        for (int k = 1; k < along.length; k++) {
          addArc(along[k - 1], along[k], isFixed ? -1 : rings.ringOf(e));
        }
      }
    }
    return true;
  }

  private void addArc(int u, int v, int ring) {
    if (points.same(u, v)) {
      return;
    }
    long key = Rings.key(meetings.place(u), meetings.place(v));
    int arc = arcOf.computeIfAbsent(key, none -> ends.size());
    if (arc == ends.size()) {
      ends.add(points.yxLess(u, v) ? new int[] {v, u} : new int[] {u, v});
      ringsOf.add(new int[0]);
    }
    if (ring >= 0) {
      int[] more = Arrays.copyOf(ringsOf.get(arc), ringsOf.get(arc).length + 1);
      more[more.length - 1] = ring;
      ringsOf.set(arc, more);
    }
  }

  // ---- the sweep

  private boolean sweep(Progress progress) {
    int n = points.size();
    joined = new int[2 * ends.size() + 1];
    Arrays.setAll(joined, face -> face);
    faceOfSite = new int[n];
    findRound();
    SweepStatus status = new SweepStatus(points, ends.size());
    for (int k = n - 1; k >= 0; k--) {
      Progress.check(progress, n - 1 - k);
      int v = order[k];
      if (meetings.place(v) == v && !meet(status, v)) {
        return false;
      }
    }
    Arrays.setAll(joined, this::face);
    return true;
  }

  /** The arcs at each place, clockwise from the left one above it. */
  private void findRound() {
    int n = points.size();
    int[] degree = new int[n];
    for (int[] arc : ends) {
      degree[meetings.place(arc[0])]++;
      degree[meetings.place(arc[1])]++;
    }
    round = new int[n][];
    Arrays.setAll(round, v -> new int[degree[v]]);
    for (int a = 0; a < ends.size(); a++) {
      for (int end : ends.get(a)) {
        int v = meetings.place(end);
        int k = round[v].length - degree[v]--;
        while (k > 0 && isBefore(v, a, round[v][k - 1])) {
          round[v][k] = round[v][k - 1];
          k--;
        }
        round[v][k] = a;
      }
    }
  }

  /** Whether arc a stands before arc b clockwise round v. */
  private boolean isBefore(int v, int a, int b) {
    int p = otherEnd(a, v);
    int q = otherEnd(b, v);
    boolean isUp = rank[p] > rank[v];
    return isUp == rank[q] > rank[v] ? points.orient(v, p, q) < 0 : isUp;
  }

  /** The end of an arc that is not at the place v. */
  int otherEnd(int arc, int v) {
    int[] both = ends.get(arc);
    return points.same(both[0], v) ? both[1] : both[0];
  }

  /** The end of an arc at the place v. */
  int end(int arc, int v) {
    int[] both = ends.get(arc);
    return points.same(both[0], v) ? both[0] : both[1];
  }

  /** Lets arcs end and start at v; false if v lies on one, which rounding has hidden. */
  private boolean meet(SweepStatus status, int v) {
    int[] all = round[v];
    int above = (int) Arrays.stream(all).filter(a -> rank[otherEnd(a, v)] > rank[v]).count();
    int before;
    if (above == 0) {
      before = status.search(v);
      if (status.touched() != SweepStatus.NONE) {
        return false;
      }
    } else {
      before = status.before(all[0]);
      for (int k = 0; k < above; k++) {
        status.remove(all[k]);
      }
    }
    int behind = status.after(before);
    faceOfSite[v] = right(before);
    int last = before;
    for (int k = all.length - 1; k >= above; k--) {
      status.insertAfter(last, all[k], v, otherEnd(all[k], v));
      join(right(last), left(all[k]));
      last = all[k];
    }
    join(right(last), left(behind));
    return true;
  }

  private static int left(int arc) {
    return arc == SweepStatus.NONE ? OUTSIDE : 2 * arc + 1;
  }

  private static int right(int arc) {
    return arc == SweepStatus.NONE ? OUTSIDE : 2 * arc + 2;
  }

  private int face(int of) {
    int face = of;
    while (joined[face] != face) {
      joined[face] = joined[joined[face]];
      face = joined[face];
    }
    return face;
  }

  private void join(int a, int b) {
    joined[face(a)] = face(b);
  }

  // ---- what is inside

  /** Walks through all faces from the outside; false if there is one that holes have twice. */
  private boolean findInside() {
    Map<Integer, List<Integer>> arcs = new HashMap<>(); // by face
    for (int a = 0; a < ends.size(); a++) {
      arcs.computeIfAbsent(joined[left(a)], none -> new ArrayList<>()).add(a);
      arcs.computeIfAbsent(joined[right(a)], none -> new ArrayList<>()).add(a);
    }
    inside = new boolean[joined.length];
    BitSet[] within = new BitSet[joined.length]; // by face: the rings that it is in
    int[] waiting = new int[joined.length];
    int first = joined[OUTSIDE];
    within[first] = new BitSet();
    waiting[0] = first;
    for (int done = 0, known = 1; done < known; done++) {
      int face = waiting[done];
      for (int a : arcs.getOrDefault(face, List.of())) {
        int other = joined[left(a)] == face ? joined[right(a)] : joined[left(a)];
        if (within[other] == null) {
          within[other] = (BitSet) within[face].clone();
          Arrays.stream(ringsOf.get(a)).forEach(within[other]::flip);
          waiting[known++] = other;
        }
      }
      boolean isInOuter = within[face].get(0);
      int holes = within[face].cardinality() - (isInOuter ? 1 : 0);
      if (holes > (isInOuter ? 1 : 0)) {
        return false;
      }
      inside[face] = isInOuter && holes == 0;
    }
    return true;
  }

  private boolean areSitesAndFixedEdgesInside() {
    for (int v = 0; v < points.size(); v++) {
      if (round[v].length == 0 && meetings.place(v) == v && !inside[joined[faceOfSite[v]]]) {
        return false;
      }
    }
    for (int j = 0; j < rings.fixedCount(); j++) {
      int arc = fixedArc(j);
      if (!isInsideOnLeft(arc) && !isInsideOnRight(arc)) {
        return false;
      }
    }
    return true;
  }

  // ---- for those who walk round the faces

  /** The vertex that stands for the place of v. */
  int place(int v) {
    return meetings.place(v);
  }

  /** The number of arcs. */
  int arcs() {
    return ends.size();
  }

  /** The arc of the j-th fixed edge. */
  int fixedArc(int j) {
    return arcOf.get(
        Rings.key(meetings.place(rings.fixedFrom(j)), meetings.place(rings.fixedTo(j))));
  }

  /** The upper and the lower end of an arc. */
  int[] ends(int arc) {
    return ends.get(arc);
  }

  /** The arcs at the place of v, clockwise. */
  int[] round(int v) {
    return round[meetings.place(v)];
  }

  boolean isInsideOnLeft(int arc) {
    return inside[joined[left(arc)]];
  }

  boolean isInsideOnRight(int arc) {
    return inside[joined[right(arc)]];
  }

  /** The face on the side of the arc that is inside; any of both if both are. */
  int insideFace(int arc) {
    return joined[isInsideOnLeft(arc) ? left(arc) : right(arc)];
  }

  /** Both faces beside the arc. */
  int[] faces(int arc) {
    return new int[] {joined[left(arc)], joined[right(arc)]};
  }

  /** The face of a vertex without arcs. */
  int faceOfSite(int v) {
    return joined[faceOfSite[v]];
  }

  /** The number of faces, including those that are the same as others. */
  int count() {
    return joined.length;
  }
}
