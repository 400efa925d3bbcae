package dct.io.format.mesh;

import dct.core.geometry.Points;
import dct.io.format.RegionShape;
import dct.io.format.Rim;
import dct.io.format.Shapes;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Segments between numbered vertices, as the outline of a region: of the rings that they make, the
 * one round all others is the outer one, those innermost round a hole's point are holes. All other
 * segments are fixed edges, and vertices on no ring are sites.
 *
 * <p>Segments that lead to a vertex with no other are no part of a ring. Where the rest branches,
 * the rings are made of the marked segments alone, as Triangle marks those of the boundary. Linear,
 * but for the search for the rings round holes.
 */
final class Segments {
  private static final String BRANCH =
      " segments of rings end at this vertex, where rings touch; list it once for each ring, and"
          + " give --touching split or --touching hair";

  private static final String UNMARKED =
      " segments end at this vertex, and no markers tell which are of rings; give those of rings the"
          + " marker 1";
  private static final String OPEN =
      "only one segment ends at this vertex, and there is no ring; add the segments that close it";

  private final int vertices;
  private final List<Segment> all = new ArrayList<>();

  private record Segment(int from, int to, boolean isMarked) {
    int[] ends() {
      return new int[] {from, to};
    }
  }

  /** None yet, among so many vertices. */
  Segments(int vertices) {
    this.vertices = vertices;
  }

  /** Adds the segment between two vertices that there are. */
  void add(int u, int v, boolean isMarked) {
    all.add(new Segment(u, v, isMarked));
  }

  /**
   * The region; without rings if there are none.
   *
   * @param holes a point in each hole
   */
  RegionShape region(Points points, int[] lines, Points holes) {
    List<int[]> rings = cycles(all);
    if (rings.isEmpty()) {
      rings = cycles(all.stream().filter(Segment::isMarked).toList());
    }
    int[] fixed = all.stream().flatMapToInt(s -> IntStream.of(s.ends())).toArray();
    RegionShape whole = new RegionShape("", points, lines, rings, fixed).outerFirst();
    return new RegionShape("", points, lines, outerAndHoles(points, whole.rings(), holes), fixed);
  }

  private static List<int[]> outerAndHoles(Points points, List<int[]> rings, Points holes) {
    boolean[] isHole = new boolean[rings.size()];
    for (int ring : Nest.innermost(points, rings, holes)) {
      if (ring > 0) {
        isHole[ring] = true;
      }
    }
    List<int[]> kept = new ArrayList<>();
    for (int r = 0; r < isHole.length; r++) {
      if (r == 0 || isHole[r]) {
        kept.add(rings.get(r));
      }
    }
    return kept;
  }

  /** What keeps the segments from being rings: a vertex where too many end, or one only. */
  Optional<Shapes.Fault> fault(int... lines) {
    List<Segment> marked = all.stream().filter(Segment::isMarked).toList();
    int[] left = degrees(marked.isEmpty() ? all : marked, true);
    String branch = marked.isEmpty() ? UNMARKED : BRANCH;
    int[] ends = degrees(all, false);
    return IntStream.range(0, vertices)
        .filter(v -> left[v] > 2)
        .mapToObj(v -> new Shapes.Fault(lines[v], left[v] + branch))
        .findFirst()
        .or(
            () ->
                IntStream.range(0, vertices)
                    .filter(v -> ends[v] == 1)
                    .mapToObj(v -> new Shapes.Fault(lines[v], OPEN))
                    .findFirst());
  }

  /** How many segments end at each vertex, perhaps without those that lead nowhere. */
  private int[] degrees(List<Segment> segments, boolean isOfRings) {
    List<Segment> different = segments.stream().filter(s -> s.from != s.to).toList();
    int[] degree = new int[vertices];
    if (isOfRings) {
      withoutEnds(different, degree);
    } else {
      different.stream().flatMapToInt(s -> IntStream.of(s.ends())).forEach(v -> degree[v]++);
    }
    return degree;
  }

  /** The cycles of segments, without those that lead nowhere; none if they branch. */
  private List<int[]> cycles(List<Segment> segments) {
    List<Segment> different = segments.stream().filter(s -> s.from != s.to).toList();
    int[] degree = new int[vertices];
    boolean[] isGone = withoutEnds(different, degree);
    Rim rim = new Rim(vertices);
    for (int s = 0; s < isGone.length; s++) {
      Segment segment = different.get(s);
      if (!isGone[s]) {
        if (degree[segment.from] > 2 || degree[segment.to] > 2) {
          return List.of();
        }
        rim.add(segment.from, segment.to);
      }
    }
    return rim.rings();
  }

  /**
   * Takes segments away that lead to a vertex with no other, until there are none.
   *
   * @param degree becomes the number of segments left at each vertex
   * @return which of them are gone
   */
  private static boolean[] withoutEnds(List<Segment> segments, int[] degree) {
    int[] last = new int[degree.length]; // the numbers of the segments left at a vertex, by xor
    for (int s = 0; s < segments.size(); s++) {
      for (int v : segments.get(s).ends()) {
        degree[v]++;
        last[v] ^= s;
      }
    }
    boolean[] isGone = new boolean[segments.size()];
    for (int start = 0; start < degree.length; start++) {
      int v = start;
      while (degree[v] == 1) {
        int s = last[v];
        isGone[s] = true;
        int next = segments.get(s).from == v ? segments.get(s).to : segments.get(s).from;
        for (int end : segments.get(s).ends()) {
          degree[end]--;
          last[end] ^= s;
        }
        v = next;
      }
    }
    return isGone;
  }
}
