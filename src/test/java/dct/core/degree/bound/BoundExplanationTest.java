package dct.core.degree.bound;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.Explanation;
import dct.core.degree.LowerBound;
import dct.core.degree.Mark;
import dct.core.degree.Mark.Tone;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.HullRing;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.Triangulation;
import dct.testing.RandomSets.Family;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** What is drawn to explain a bound has the bound's number. */
class BoundExplanationTest {

  private static Triangulation delaunay(double... pairs) {
    return Delaunay.triangulate(Sites.of(Points.ofPairs(pairs), Progress.NONE), Progress.NONE);
  }

  private static <T extends Mark> List<T> marks(Explanation explanation, Class<T> type) {
    return explanation.marks().stream().filter(type::isInstance).map(type::cast).toList();
  }

  private static List<Mark.Vertex> faults(Explanation explanation) {
    return marks(explanation, Mark.Vertex.class).stream()
        .filter(mark -> mark.tone() == Tone.FAULT)
        .toList();
  }

  private static LowerBound bound(int value) {
    return new LowerBound(value, "");
  }

  private static Explanation allEven(Triangulation any, int value) {
    ParityGoal goal = ParityGoal.allEven(any.vertexCount());
    return BoundExplanation.of(any, goal, bound(value), Progress.NONE).orElseThrow();
  }

  private static Triangulation polygon(int n) {
    double[] pairs = new double[2 * n];
    for (int i = 0; i < n; i++) {
      pairs[2 * i] = i;
      pairs[2 * i + 1] = i * i;
    }
    SimplePolygon convex = SimplePolygon.of(Points.ofPairs(pairs), Progress.NONE);
    return EarClipping.triangulate(convex, Progress.NONE);
  }

  private static Triangulation annulus(int outer, int inner) {
    Points points = round(outer, 100);
    for (int k = 0; k < inner; k++) {
      points = points.inserted(points.size(), round(inner, 40).x(k), round(inner, 40).y(k));
    }
    int[] ring = IntStream.range(0, outer).toArray();
    int[] hole = IntStream.range(outer, outer + inner).toArray();
    Rings rings = Rings.of(points, List.of(ring, hole));
    return EarClipping.triangulate(Region.of(rings, Progress.NONE), Progress.NONE);
  }

  private static Points round(int n, double radius) {
    double[] pairs = new double[2 * n];
    for (int i = 0; i < n; i++) {
      pairs[2 * i] = radius * Math.cos(2 * Math.PI * i / n);
      pairs[2 * i + 1] = radius * Math.sin(2 * Math.PI * i / n);
    }
    return Points.ofPairs(pairs);
  }

  @Test
  void theBoundaryIsCountedInThrees() {
    Explanation fourteen = allEven(polygon(14), 2);
    assertThat(fourteen.title()).isEqualTo("3 does not divide the 14 vertices");
    assertThat(fourteen.text()).contains("14 = 3 × 4 + 2");
    assertThat(marks(fourteen, Mark.Vertex.class))
        .hasSize(14)
        .extracting(Mark.Vertex::label)
        .startsWith("1", "2", "3", "1", "2", "3")
        .endsWith("1", "2");
    assertThat(faults(fourteen)).extracting(Mark.Vertex::vertex).containsExactly(12, 13);
    Explanation twelve = allEven(polygon(12), 0);
    assertThat(twelve.title()).isEqualTo("3 divides the 12 vertices");
    assertThat(faults(twelve)).isEmpty();
    Explanation annulus = allEven(annulus(6, 4), 2);
    assertThat(annulus.title()).startsWith("3 divides the numbers of vertices of all rings but");
    assertThat(annulus.text()).contains("only the ring of 4 vertices leaves a rest");
    assertThat(marks(annulus, Mark.Vertex.class)).hasSize(10);
    assertThat(faults(annulus)).extracting(Mark.Vertex::label).containsExactly("1");
    Explanation both = allEven(annulus(5, 4), 0);
    assertThat(both.text()).contains("the rests of the 2 rings that 3 does not divide cancel");
    assertThat(faults(both)).hasSize(3);
    Explanation sites = allEven(delaunay(0, 0, 5, 0, 5, 5, 0, 5, 2, 2), 2);
    assertThat(sites.title()).isEqualTo("3 does not divide the 4 hull sites");
    assertThat(marks(sites, Mark.Vertex.class)).hasSize(4);
  }

  @Test
  void everyBoundOfSmallSetsIsExplainedByMarksThatBearItOut() {
    Map<String, Integer> kinds = new TreeMap<>();
    for (Family family : SmallSets.families()) {
      for (long seed = 0; seed < 12; seed++) {
        Sites sites = family.make(4 + (int) (seed % 8), seed);
        Triangulation any = Delaunay.triangulate(sites, Progress.NONE);
        if (any.triangleCount() > 0) {
          Random random = new Random(seed);
          HullRing ring = HullRing.of(any);
          for (ParityGoal goal :
              List.of(
                  ParityGoal.allEven(sites.size()),
                  ParityGoal.allOdd(sites.size()),
                  SmallSets.randomHullGoal(ring, random),
                  SmallSets.randomGoal(sites.size(), random))) {
            int value = SiteBounds.of(any, goal, Progress.NONE).value();
            Optional<Explanation> why = BoundExplanation.of(any, goal, bound(value), Progress.NONE);
            assertThat(why).as("%s, seed %d, %s", family, seed, goal).isPresent();
            String kind = check(why.get(), ring, goal, value);
            kinds.merge(kind, 1, Integer::sum);
          }
        }
      }
    }
    assertThat(kinds)
        .containsOnlyKeys(
            "colours", "count", "degree sum", "handshake", "lattice", "side", "three", "walk");
  }

  /** Checks the marks against the number, and names the kind. */
  private static String check(Explanation why, HullRing ring, ParityGoal goal, int value) {
    String title = why.title();
    if (title.startsWith("3 ")) {
      assertThat(value).isEqualTo(faults(why).isEmpty() ? 0 : 2);
      assertThat(faults(why)).hasSize(ring.size() % 3);
      return "count";
    } else if (title.startsWith("The colours")) {
      checkColours(why, ring, goal, value);
      return "colours";
    } else if (title.startsWith("The degrees")) {
      int sum =
          marks(why, Mark.Vertex.class).stream().mapToInt(m -> Integer.parseInt(m.label())).sum();
      int edges = 3 * goal.size() - 3 - ring.size();
      assertThat(new Handshake(goal).roundUp(sum - 2 * edges)).isEqualTo(value);
      return "degree sum";
    } else if (title.startsWith("The number of odd")) {
      assertThat(why.marks()).hasSize(goal.count(Wish.ODD));
      return "handshake";
    } else if (title.startsWith("The sites are all")) {
      checkLattice(why, ring);
      return "lattice";
    } else if (title.startsWith("One side")) {
      checkSide(why, ring, goal, value);
      return "side";
    } else if (title.startsWith("Only three")) {
      assertThat(marks(why, Mark.Vertex.class))
          .extracting(Mark.Vertex::vertex)
          .containsExactly(ring.site(0), ring.site(1), ring.site(2));
      return "three";
    } else if (title.startsWith("Round the hull")) {
      checkWalk(why, ring, goal, value);
      return "walk";
    }
    return title;
  }

  private static void checkColours(Explanation why, HullRing ring, ParityGoal goal, int value) {
    List<Mark.Segment> edges = marks(why, Mark.Segment.class);
    assertThat(edges).hasSize(ring.size());
    int difference = 0;
    Set<Integer> missed = new TreeSet<>();
    for (int k = 0; k < edges.size(); k++) {
      difference += edges.get(k).tone() == Tone.BLACK ? 1 : -1;
      Mark.Segment before = edges.get((k + edges.size() - 1) % edges.size());
      assertThat(before.to()).isEqualTo(edges.get(k).from());
      boolean changes = before.tone() != edges.get(k).tone();
      if (!goal.wish(edges.get(k).from()).isGrantedBy(changes ? 1 : 2)) {
        missed.add(edges.get(k).from());
      }
    }
    assertThat(difference % 3).isZero();
    assertThat(faults(why)).extracting(Mark.Vertex::vertex).hasSameElementsAs(missed);
    int least = ring.interior() == 0 ? missed.size() : Math.min(1, missed.size());
    assertThat(new Handshake(goal).roundUp(least)).isEqualTo(value);
  }

  private static void checkLattice(Explanation why, HullRing ring) {
    List<Mark.Segment> edges = marks(why, Mark.Segment.class);
    assertThat(edges).hasSize(ring.size());
    for (Mark.Segment edge : edges) {
      assertThat(edge.tone()).isIn(Tone.ONE, Tone.TWO, Tone.THREE);
    }
  }

  private static void checkSide(Explanation why, HullRing ring, ParityGoal goal, int value) {
    List<Mark.Segment> edges = marks(why, Mark.Segment.class);
    int inside = edges.size() - 1;
    int start = edges.get(0).from();
    int end = edges.get(inside).to();
    int even = 0;
    for (Mark.Vertex flat : marks(why, Mark.Vertex.class)) {
      assertThat(ring.points().orient(start, end, flat.vertex())).isZero();
      even += goal.wish(flat.vertex()) == Wish.EVEN ? 1 : 0;
    }
    assertThat(marks(why, Mark.Vertex.class)).hasSize(inside);
    int others = ring.size() - inside - 2;
    int least = even - 2 * ring.interior() - others + 1;
    assertThat(new Handshake(goal).roundUp(least)).isEqualTo(value);
  }

  /** The triangles are empty, one lies on each hull edge, and they miss what is marked. */
  private static void checkWalk(Explanation why, HullRing ring, ParityGoal goal, int value) {
    List<Mark.Area> areas = marks(why, Mark.Area.class);
    boolean coloured = areas.get(0).tone() != Tone.MAIN;
    for (Mark.Area area : areas) {
      assertThat(isEmpty(ring.points(), area.corners())).as("%s", area).isTrue();
    }
    Map<Integer, Tone> toneAfter = new TreeMap<>(); // of the triangle on the edge after a hull site
    for (int k = 0; k < 2 * ring.size(); k++) { // twice, for an ear may be the first
      List<Mark.Area> own = startingAt(areas, ring.site(k));
      if (!own.isEmpty()) {
        assertThat(own.get(0).corners().get(1)).isEqualTo(ring.site(k + 1));
      }
      Tone tone = own.isEmpty() ? toneAfter.get(ring.site(k - 1)) : own.get(0).tone();
      toneAfter.put(ring.site(k), tone);
    }
    Set<Integer> missed = new TreeSet<>();
    int difference = 0;
    for (int k = 0; k < ring.size(); k++) {
      int degree = startingAt(areas, ring.site(k)).size() + 2;
      if (!goal.wish(ring.site(k)).isGrantedBy(degree)) {
        missed.add(ring.site(k));
      }
      difference += toneAfter.get(ring.site(k)) == Tone.BLACK ? 1 : -1;
      boolean changes = toneAfter.get(ring.site(k)) != toneAfter.get(ring.site(k - 1));
      assertThat(changes).isEqualTo(coloured && degree % 2 == 1);
    }
    assertThat(!coloured || difference % 3 == 0).isTrue();
    assertThat(faults(why)).extracting(Mark.Vertex::vertex).hasSameElementsAs(missed);
    int cost = missed.size();
    boolean plus = why.text().contains("Either way there is one more.");
    assertThat(new Handshake(goal).roundUp(plus ? cost + 1 : cost)).isEqualTo(value);
  }

  private static List<Mark.Area> startingAt(List<Mark.Area> areas, int v) {
    return areas.stream().filter(area -> area.corners().get(0) == v).toList();
  }

  private static boolean isEmpty(Points points, List<Integer> corners) {
    int a = corners.get(0);
    int b = corners.get(1);
    int c = corners.get(2);
    int turn = points.orient(a, b, c);
    for (int d = 0; d < points.size(); d++) {
      boolean isInside =
          points.orient(a, b, d) * turn >= 0
              && points.orient(b, c, d) * turn >= 0
              && points.orient(c, a, d) * turn >= 0;
      if (!corners.contains(d) && isInside) {
        return false;
      }
    }
    return turn != 0;
  }

  @Test
  void ofASmallCrossEverySetOfTwoIsRefuted() {
    double[] pairs = SmallSets.cross(10, 10);
    Explanation why = allEven(delaunay(pairs), 4);
    assertThat(why.title()).isEqualTo("Refuted: 821 sets of at most 2 odd vertices");
    List<Mark.Vertex> marked = marks(why, Mark.Vertex.class);
    assertThat(marked).isNotEmpty().hasSizeLessThan(41);
    assertThat(why.sentences())
        .anyMatch(sentence -> sentence.contains("the " + marked.size() + " marked vertices"));
  }

  @Test
  void armsOfALargeCrossAreWindows() {
    double[] pairs = SmallSets.cross(300, 3);
    Explanation why = allEven(delaunay(pairs), 4);
    List<Mark.Band> bands = marks(why, Mark.Band.class);
    assertThat(why.title()).isEqualTo(bands.size() + " windows cannot be all even");
    assertThat(bands.size() + bands.size() % 2).isEqualTo(4);
    assertThat(marks(why, Mark.Vertex.class))
        .extracting(Mark.Vertex::vertex)
        .doesNotHaveDuplicates();
    assertThat(bands).extracting(Mark.Band::label).startsWith("1", "2", "3");
    for (int k = 1; k < bands.size(); k++) {
      Mark.Band one = bands.get(k - 1);
      Mark.Band next = bands.get(k);
      assertThat(
              one.right() <= next.left()
                  || next.right() <= one.left()
                  || one.high() <= next.low()
                  || next.high() <= one.low())
          .isTrue();
    }
  }

  @Test
  void boundsOfPolygonsFollowFromTheWishes() {
    for (long seed = 0; seed < 40; seed++) {
      int n = 5 + (int) (seed % 9);
      Triangulation any = polygon(n);
      ParityGoal goal =
          seed % 4 == 0 ? ParityGoal.allOdd(n) : SmallSets.randomGoal(n, new Random(seed));
      int value = PolygonBounds.of(n, goal).value();
      Explanation why = BoundExplanation.of(any, goal, bound(value), Progress.NONE).orElseThrow();
      if (why.title().startsWith("The colours")) {
        assertThat(new Handshake(goal).roundUp(faults(why).size())).isEqualTo(value);
      }
      assertThat(BoundExplanation.of(any, goal, bound(value + 1), Progress.NONE)).isEmpty();
    }
    Triangulation eight = polygon(8);
    Explanation ears =
        BoundExplanation.of(eight, ParityGoal.allOdd(8), bound(2), Progress.NONE).orElseThrow();
    assertThat(ears.title()).isEqualTo("Two ears have even tips");
    assertThat(marks(ears, Mark.Area.class)).hasSizeGreaterThanOrEqualTo(2);
    for (Mark.Vertex tip : marks(ears, Mark.Vertex.class)) {
      assertThat(eight.degree(tip.vertex())).isEqualTo(2);
    }
  }

  @Test
  void sitesOnOneLineHaveOneTriangulation() {
    Explanation why = allEven(delaunay(0, 0, 2, 1, 4, 2, 6, 3), 2);
    assertThat(why.title()).isEqualTo("All sites lie on one line");
    assertThat(faults(why)).extracting(Mark.Vertex::vertex).containsExactly(0, 3);
  }
}
