package dct.core.geometry;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The parts of what is inside that hang together, and their rings: walks along the arcs that have
 * the inside on one side, always keeping it on the left, taken apart where they come to a place
 * again. Linear.
 */
final class Pieces {
  private final Rings rings;
  private final Faces faces;
  private final int[] part; // by face: one of the same part, in the end that which stands for it
  private final Map<Integer, Draft> drafts = new TreeMap<>(); // by the face that stands for it

  /** A piece in the making: loops of vertices, fixed edges, and sites. */
  private static final class Draft {
    final List<int[]> loops = new ArrayList<>();
    final List<int[]> fixed = new ArrayList<>();
    final List<Integer> sites = new ArrayList<>();
  }

  Pieces(Rings rings, Faces faces) {
    this.rings = rings;
    this.faces = faces;
    part = new int[faces.count()];
    Arrays.setAll(part, face -> face);
  }

  /** The pieces in the order of their lowest vertices. */
  List<Piece> all() {
    joinParts();
    walk();
    addFixed();
    for (int v = 0; v < rings.points().size(); v++) {
      if (!rings.isOnRing(v)) {
        draft(faces.faceOfSite(v)).sites.add(v);
      }
    }
    return drafts.values().stream()
        .map(this::piece)
        .sorted(Comparator.comparingInt(piece -> piece.vertices()[0]))
        .toList();
  }

  private Draft draft(int face) {
    return drafts.computeIfAbsent(partOf(face), none -> new Draft());
  }

  private int partOf(int of) {
    int face = of;
    while (part[face] != face) {
      part[face] = part[part[face]];
      face = part[face];
    }
    return face;
  }

  /** Joins the faces on both sides of arcs that are inside. */
  private void joinParts() {
    for (int a = 0; a < faces.arcs(); a++) {
      if (faces.isInsideOnLeft(a) && faces.isInsideOnRight(a)) {
        int[] both = faces.faces(a);
        part[partOf(both[0])] = partOf(both[1]);
      }
    }
  }

  private boolean isBoundary(int arc) {
    return faces.isInsideOnLeft(arc) != faces.isInsideOnRight(arc);
  }

  /** The vertex where an arc of the boundary starts if the inside is on its left. */
  private int start(int arc) {
    return faces.ends(arc)[faces.isInsideOnLeft(arc) ? 1 : 0];
  }

  private void walk() {
    Loops loops = new Loops(rings.points().size());
    boolean[] isDone = new boolean[faces.arcs()];
    for (int first = 0; first < isDone.length; first++) {
      if (isBoundary(first) && !isDone[first]) {
        for (int arc = first; !isDone[arc]; arc = next(arc)) {
          isDone[arc] = true;
          loops.add(start(arc), faces.place(start(arc)));
        }
        draft(faces.insideFace(first)).loops.addAll(loops.finished());
      }
    }
  }

  /** The arc that follows on a walk: the first one of the boundary clockwise from this one. */
  private int next(int arc) {
    int v = faces.otherEnd(arc, start(arc));
    int[] round = faces.round(v);
    int k = 0;
    while (round[k] != arc) {
      k++;
    }
    do {
      k = k + 1 == round.length ? 0 : k + 1;
    } while (!isBoundary(round[k]));
    return round[k];
  }

  private void addFixed() {
    for (int j = 0; j < rings.fixedCount(); j++) {
      int arc = faces.fixedArc(j);
      if (!isBoundary(arc)) {
        draft(faces.insideFace(arc)).fixed.add(new int[] {rings.fixedFrom(j), rings.fixedTo(j)});
      }
    }
  }

  // ---- from a draft to a piece

  /** A vertex of a loop, or a site. */
  private record Corner(int vertex, int loop, int index) {}

  private Piece piece(Draft draft) {
    List<int[]> loops = new ArrayList<>(draft.loops);
    int outer = 0;
    while (!isLeftTurning(loops.get(outer))) {
      outer++;
    }
    loops.add(0, loops.remove(outer));
    List<Corner> corners = new ArrayList<>();
    for (int l = 0; l < loops.size(); l++) {
      for (int k = 0; k < loops.get(l).length; k++) {
        corners.add(new Corner(loops.get(l)[k], l, k));
      }
    }
    draft.sites.forEach(v -> corners.add(new Corner(v, loops.size(), 0)));
    corners.sort(Comparator.comparingInt(Corner::vertex).thenComparingInt(Corner::loop));
    return piece(draft, loops, corners);
  }

  private Piece piece(Draft draft, List<int[]> loops, List<Corner> corners) {
    Map<Integer, Integer> numbers = new HashMap<>(); // of the first vertex at each place
    List<int[]> numbered = loops.stream().map(int[]::clone).toList();
    for (int i = 0; i < corners.size(); i++) {
      Corner corner = corners.get(i);
      numbers.putIfAbsent(faces.place(corner.vertex), i);
      if (corner.loop < loops.size()) {
        numbered.get(corner.loop)[corner.index] = i;
      }
    }
    int[] fixed =
        draft.fixed.stream()
            .flatMapToInt(Arrays::stream)
            .map(v -> numbers.get(faces.place(v)))
            .toArray();
    int[] vertices = corners.stream().mapToInt(Corner::vertex).toArray();
    return new Piece(vertices, numbered, fixed, numbers.size() < vertices.length);
  }

  /** Whether a loop, which is simple, runs counter-clockwise. */
  private boolean isLeftTurning(int... loop) {
    Points points = rings.points();
    int low = 0;
    for (int k = 1; k < loop.length; k++) {
      low = points.yxLess(loop[k], loop[low]) ? k : low;
    }
    int before = loop[low == 0 ? loop.length - 1 : low - 1];
    int after = loop[low + 1 == loop.length ? 0 : low + 1];
    return points.orient(before, loop[low], after) > 0;
  }
}
