package dct.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.geometry.Defect.Kind;
import dct.testing.RandomRegions;
import dct.testing.RandomSets;
import dct.testing.RegionOracle;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * The sweep against a look at every pair of edges, and what it says of each kind of fault.
 *
 * <pre>
 * Points points = Points.ofPairs(0, 0, 9, 0, 9, 9, 0, 9, 3, 3, 6, 3, 3, 6, 7, 7);
 * Rings rings = Rings.of(points, List.of(new int[] {0, 1, 2, 3}, new int[] {4, 5, 6}), 6, 7);
 * Region region = Region.of(rings, Progress.NONE);
 * region.holes(); // 1
 * region.sites(); // 1
 * region.triangles(); // 9
 * </pre>
 */
class RegionTest {
  private static final Points SQUARE_AND_HOLE =
      Points.ofPairs(0, 0, 9, 0, 9, 9, 0, 9, 3, 3, 6, 3, 3, 6, 7, 7);

  private static final int[] OUTER = {0, 1, 2, 3};
  private static final int[] HOLE = {4, 5, 6};

  @Test
  void aSquareWithAHoleASiteAndAFixedEdge() {
    Region region = Region.of(Rings.of(SQUARE_AND_HOLE, List.of(OUTER, HOLE), 6, 7), Progress.NONE);
    assertThat(region.holes()).isEqualTo(1);
    assertThat(region.sites()).isEqualTo(1);
    assertThat(region.triangles()).isEqualTo(9);
    assertThat(region.isFixed(7, 6)).isTrue();
    assertThat(region.isFixed(4, 5)).isFalse();
  }

  @Test
  void holesAreWalkedClockwiseAndTheOuterRingCounterClockwise() {
    for (int[] outer : List.of(OUTER, new int[] {3, 2, 1, 0})) {
      for (int[] hole : List.of(HOLE, new int[] {6, 5, 4})) {
        Region region = Region.of(Rings.of(SQUARE_AND_HOLE, List.of(outer, hole)), Progress.NONE);
        for (int k = 0; k < region.positions(); k++) {
          int turn =
              region
                  .points()
                  .orient(
                      region.vertex(region.before(k)),
                      region.vertex(k),
                      region.vertex(region.after(k)));
          assertThat(turn).isEqualTo(k < 4 ? 1 : -1);
          assertThat(region.position(region.vertex(k))).isEqualTo(k);
        }
        assertThat(region.position(7)).isEqualTo(Points.NONE);
      }
    }
  }

  @Test
  void everyFaultIsNamedWithItsPlace() {
    says(List.of(OUTER, new int[] {4, 5}), "the hole at vertex v4 has fewer than three vertices");
    says(
        List.of(HOLE, OUTER),
        "vertex v2 of a hole lies outside of the outer ring, (9, 9); "
            + "move the hole into the region, or make it a region of its own");
    says(List.of(HOLE), "site v2 lies outside of the region, (9, 9); move it inside, or remove it");
    says(
        Rings.of(
            Points.ofPairs(0, 0, 9, 0, 9, 9, 0, 9, 1, 1, 8, 1, 1, 8, 2, 2, 4, 2, 2, 4),
            List.of(OUTER, HOLE, new int[] {7, 8, 9})),
        "vertex v9 of a hole lies in the hole of v4, (2, 4); "
            + "move the hole into the region, or make it a region of its own");
    says(
        Rings.of(SQUARE_AND_HOLE.moved(7, 4, 3), List.of(OUTER, HOLE)),
        "vertex v7 touches edge v4–v5 at (4, 3); move it off the edge");
    says(
        Rings.of(SQUARE_AND_HOLE, List.of(OUTER, HOLE), 4, 7),
        "edges v5–v6 and v4–v7 cross at (4.5, 4.5); move a vertex of one of them");
    says(
        Rings.of(Points.ofPairs(0, 0, 9, 0, 9, 9, 0, 9, 3, 3), List.of(OUTER), 0, 2),
        "vertex v4 touches edge v0–v2 at (3, 3); move it off the edge");
    says(
        Rings.of(Points.ofPairs(0, 0, 9, 0, 9, 9, 4, 2), List.of(OUTER), 0, 2),
        "the fixed edge v0–v2 leaves the region; remove it, or join other vertices");
  }

  private static void says(List<int[]> rings, String sentence) {
    says(Rings.of(SQUARE_AND_HOLE, rings), sentence);
  }

  private static void says(Rings rings, String sentence) {
    assertThatThrownBy(() -> Region.of(rings, Progress.NONE)).hasMessageStartingWith(sentence);
  }

  @Test
  void fixedEdgesThatAreSidesOrRepeatedAreLeftOut() {
    Rings rings = Rings.of(SQUARE_AND_HOLE, List.of(OUTER, HOLE), 6, 7, 7, 6, 0, 1, 3, 0, 5, 5);
    assertThat(rings.fixed()).containsExactly(6, 7);
  }

  @Test
  void everyRandomRegionIsOne() {
    for (RandomSets.Family family : RandomSets.families()) {
      for (int seed = 0; seed < 60; seed++) {
        Rings rings = RandomRegions.make(family, 4 + seed, seed % 4, 5 * (seed % 5), seed);
        Optional<Defect> found = SimplicityCheck.firstDefect(rings, Progress.NONE);
        assertThat(found).as("%s, seed %d", family, seed).isEmpty();
      }
    }
  }

  /** A vertex goes elsewhere, or a fixed edge is added: mostly a single fault. */
  @Test
  void agreesWithEveryPairOnSpoiltRegions() {
    int valid = 0;
    List<Kind> kinds = new ArrayList<>();
    for (int seed = 0; seed < 20_000; seed++) {
      RandomSets.Family family = RandomSets.families().get(seed % 2 == 0 ? 1 : 2);
      Rings rings = RandomRegions.make(family, 5 + seed % 20, seed % 4, 10 * (seed % 3), seed);
      Rings spoilt = spoilt(rings, new Random(seed));
      Optional<Defect> found = SimplicityCheck.firstDefect(spoilt, Progress.NONE);
      assertThat(found.isEmpty())
          .as("a region, seed %d: %s", seed, found)
          .isEqualTo(RegionOracle.isRegion(spoilt));
      valid += found.isEmpty() ? 1 : 0;
      found.map(Defect::kind).ifPresent(kinds::add);
    }
    assertThat(valid).isBetween(2_000, 18_000);
    assertThat(kinds)
        .contains(
            Kind.CROSSING,
            Kind.TOUCH,
            Kind.DUPLICATE,
            Kind.OVERLAP,
            Kind.SPIKE,
            Kind.STRAY_HOLE,
            Kind.STRAY_SITE,
            Kind.STRAY_EDGE);
  }

  private static Rings spoilt(Rings rings, Random random) {
    Points p = rings.points();
    int n = p.size();
    List<int[]> chains = new ArrayList<>();
    for (int r = 0; r < rings.count(); r++) {
      chains.add(rings.ring(r));
    }
    int a = random.nextInt(n);
    int b = random.nextInt(n);
    if (random.nextInt(3) == 0) {
      int[] fixed = Arrays.copyOf(rings.fixed(), 2 * rings.fixedCount() + 2);
      fixed[fixed.length - 2] = a;
      fixed[fixed.length - 1] = b;
      return Rings.of(p, chains, fixed);
    }
    double x = p.x(b) + random.nextInt(3) - 1;
    double y = p.y(b) + random.nextInt(3) - 1;
    return Rings.of(p.moved(a, x, y), chains, rings.fixed());
  }
}
