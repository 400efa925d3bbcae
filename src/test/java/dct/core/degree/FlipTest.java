package dct.core.degree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.dcel.DcelValidator;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.RandomSites;
import dct.testing.HandFlips;
import dct.testing.TriangulationAssert;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** Flips by hand: which edges can be flipped, what that gains, and lists of them. */
class FlipTest {
  private static Triangulation delaunay(double... pairs) {
    return Delaunay.triangulate(Sites.of(Points.ofPairs(pairs), Progress.NONE), Progress.NONE);
  }

  private static Triangulation random(int n, long seed) {
    Points points = RandomSites.uniform(n, seed);
    return Delaunay.triangulate(Sites.of(points, Progress.NONE), Progress.NONE);
  }

  @Test
  void example() {
    Triangulation square = delaunay(0, 0, 4, 0, 4, 4, 0, 3);
    int diagonal = square.edgeBetween(1, 3).orElseThrow();
    Flip flip = Flip.at(square, diagonal).orElseThrow();
    assertThat(flip.isSameAs(new Flip(3, 1, 0, 2))).isTrue();
    assertThat(flip.inverse().isSameAs(new Flip(0, 2, 1, 3))).isTrue();
    assertThat(flip.evenGain(square)).isZero(); // two corners become even, two odd
    FlipResult flipped = FlipResult.of(square, diagonal);
    assertThat(flipped.after().edgeBetween(0, 2)).hasValue(diagonal);
    assertThat(flipped.after().kind(diagonal)).isEqualTo(EdgeKind.FLIPPED);
    assertThat(FlipList.of(flipped).flips()).containsExactly(flip);
  }

  @Test
  void anEdgeOnTheBoundaryAndOneInNoStrictlyConvexQuadrilateralCannotBeFlipped() {
    Triangulation sites = delaunay(0, 0, 4, -3, 8, 0, 4, 3, 4, 0); // v4 on the line v0 v2
    int rim = sites.edgeBetween(0, 1).orElseThrow();
    int straight = sites.edgeBetween(4, 1).orElseThrow();
    assertThat(Flip.obstacle(sites, rim)).contains(Flip.Obstacle.BOUNDARY);
    assertThat(Flip.obstacle(sites, straight)).contains(Flip.Obstacle.NOT_CONVEX);
    assertThat(Flip.at(sites, straight)).isEmpty();
    assertThatThrownBy(() -> FlipResult.of(sites, straight))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("no strictly convex quadrilateral");
    assertThatThrownBy(() -> FlipResult.of(sites, rim)).hasMessageContaining("on the boundary");
    Triangulation bent = delaunay(0, 0, 9, 0, 4, 9, 4, 2);
    for (int inner = 0; inner < 3; inner++) { // at a vertex of degree 3 nothing can be flipped
      assertThat(Flip.obstacle(bent, bent.edgeBetween(3, inner).orElseThrow()))
          .contains(Flip.Obstacle.NOT_CONVEX);
    }
  }

  @Test
  void theGainIsTheChangeOfTheCountsAndEveryFlipMakesATriangulation() {
    Set<Integer> gains = new TreeSet<>();
    for (long seed = 1; seed <= 20; seed++) {
      Sites sites = Sites.of(RandomSites.uniform(25, seed), Progress.NONE);
      Triangulation before = Delaunay.triangulate(sites, Progress.NONE);
      ParityGoal goal = wishes(25);
      for (int edge = 0; edge < before.edgeCount(); edge++) {
        Optional<Flip> flip = Flip.at(before, edge);
        if (flip.isPresent()) {
          Triangulation after = FlipResult.of(before, edge).after();
          TriangulationAssert.assertThat(after).isTriangulationOf(sites);
          int gain = DegreeCount.of(after).even() - DegreeCount.of(before).even();
          gains.add(gain);
          assertThat(flip.get().evenGain(before)).isEqualTo(gain);
          assertThat(flip.get().gain(before, ParityGoal.allEven(25))).isEqualTo(gain);
          assertThat(flip.get().gain(before, ParityGoal.allOdd(25))).isEqualTo(-gain);
          assertThat(flip.get().gain(before, goal))
              .isEqualTo(goal.unmet(before) - goal.unmet(after));
        }
      }
    }
    assertThat(gains).containsExactly(-4, -2, 0, 2, 4);
  }

  private static ParityGoal wishes(int n) {
    ParityGoal.Wish[] wishes = new ParityGoal.Wish[n];
    for (int v = 0; v < n; v++) {
      wishes[v] = List.of(ParityGoal.Wish.values()).get(v % 3);
    }
    return ParityGoal.of(wishes);
  }

  @Test
  void aMixedListIsPlayedForwardsAndBackwards() {
    Triangulation start = random(60, 4);
    FlipResult scanned = ScanFlip.run(start, Progress.NONE);
    FlipResult all = scanned.then(HandFlips.of(scanned.after(), 30));
    assertThat(scanned.flips()).isPositive();
    assertThat(all.edges()).startsWith(scanned.edges().toArray(new Integer[0]));
    assertThat(new HashSet<>(all.edges())).hasSizeLessThan(all.flips()); // some edges twice
    FlipPlayer player = new FlipPlayer(all);
    List<Triangulation> forwards = new ArrayList<>();
    for (int k = 0; k <= player.size(); k++) {
      player.goTo(k);
      forwards.add(player.result().after());
      assertThat(player.index()).isEqualTo(k);
      assertThat(player.counts()).isEqualTo(DegreeCount.of(forwards.get(k)));
      DcelValidator.validate(forwards.get(k).dcel());
    }
    assertThat(edges(forwards.get(player.size()))).isEqualTo(edges(all.after()));
    for (int k : new int[] {scanned.flips(), 3, 17, 0, player.size(), 0}) {
      player.goTo(k);
      assertThat(halfEdges(player.result().after())).isEqualTo(halfEdges(forwards.get(k)));
    }
    assertThat(player.result().after()).isSameAs(start);
    assertThatThrownBy(() -> player.goTo(player.size() + 1))
        .isInstanceOf(IndexOutOfBoundsException.class);
    assertThatThrownBy(() -> player.goTo(-1)).isInstanceOf(IndexOutOfBoundsException.class);
  }

  private static List<Integer> halfEdges(Triangulation triangulation) {
    List<Integer> all = new ArrayList<>();
    for (int e = 0; e < 2 * triangulation.edgeCount(); e++) {
      all.add(triangulation.dcel().origin(e));
      all.add(triangulation.dcel().next(e));
    }
    return all;
  }

  private static Set<String> edges(Triangulation triangulation) {
    Set<String> all = new TreeSet<>();
    for (int edge = 0; edge < triangulation.edgeCount(); edge++) {
      int u = Math.min(triangulation.from(edge), triangulation.to(edge));
      int v = Math.max(triangulation.from(edge), triangulation.to(edge));
      all.add(u + " " + v + " " + triangulation.kind(edge));
    }
    return all;
  }

  @Test
  void anEdgeThatComesBackIsNotAFlippedOne() {
    Triangulation start = random(30, 2);
    int edge = 0;
    while (Flip.at(start, edge).isEmpty()) {
      edge++;
    }
    FlipResult twice = FlipResult.of(start, edge).then(edge);
    assertThat(twice.flips()).isEqualTo(2);
    assertThat(twice.after().count(EdgeKind.FLIPPED)).isZero();
    assertThat(edges(twice.after())).isEqualTo(edges(start));
  }

  @Test
  void aListIsAppliedToAnotherTriangulationAsFarAsItGoes() {
    Triangulation start = random(60, 4);
    FlipResult flips = HandFlips.of(start, 20);
    FlipList list = FlipList.of(flips);
    FlipList.Applied same = list.applyTo(random(60, 4), Progress.NONE);
    assertThat(same.cause()).isEmpty();
    assertThat(same.result().edges()).isEqualTo(flips.edges());
    assertThat(edges(same.result().after())).isEqualTo(edges(flips.after()));
    FlipList.Applied again = list.applyTo(flips.after(), Progress.NONE);
    int done = again.result().flips();
    assertThat(done).isLessThan(20);
    assertThat(again.cause().orElseThrow())
        .contains("v" + list.flips().get(done).u())
        .contains("v" + list.flips().get(done).v());
    FlipList doable = new FlipList(list.flips().subList(0, done));
    assertThat(edges(doable.applyTo(flips.after(), Progress.NONE).result().after()))
        .isEqualTo(edges(again.result().after()));
  }

  @Test
  void theCauseOfAnImpossibleFlipIsNamed() {
    Triangulation square = delaunay(0, 0, 4, 0, 4, 4, 0, 3, 9, 9);
    FlipWalk walk = new FlipWalk(square);
    assertThat(walk.flip(new Flip(0, 2, 1, 3))).contains("there is no edge v0–v2");
    assertThat(walk.flip(new Flip(1, 77, 0, 2))).contains("there is no edge v1–v77");
    assertThat(walk.flip(new Flip(0, 1, 2, 3))).contains("the edge v0–v1 is on the boundary");
    assertThat(walk.flip(new Flip(1, 3, 0, 4))).contains("the edge v1–v3 becomes v0–v2");
    assertThat(walk.flips()).isZero();
    assertThat(walk.flip(new Flip(3, 1, 2, 0))).isEmpty();
    assertThat(walk.flips()).isEqualTo(1);
  }

  @Test
  void flipsOfAnotherTriangulationDoNotFollow() {
    FlipResult flips = ScanFlip.run(random(30, 1), Progress.NONE);
    FlipResult others = ScanFlip.run(random(30, 1), Progress.NONE);
    assertThatThrownBy(() -> flips.then(others)).isInstanceOf(IllegalArgumentException.class);
  }
}
