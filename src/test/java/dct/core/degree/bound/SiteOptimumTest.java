package dct.core.degree.bound;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.DegreeCount;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.colour.HullRing;
import dct.core.degree.exact.ExactSites;
import dct.core.degree.exact.OddSetProof;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.testing.SharedData;
import dct.testing.TriangulationAssert;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Bounds and exact optima of sites against optima that other programs computed. */
class SiteOptimumTest {
  private static final int MOST_REFUTED = 16; // sites
  private static final int MOST_IN_WINDOWS = 40; // sites
  private static final List<Row> ROWS = new ArrayList<>();

  private record Row(String name, Sites sites, int least, boolean proven) {
    Triangulation start() {
      return Delaunay.triangulate(sites, Progress.NONE);
    }

    ParityGoal goal() {
      return ParityGoal.allEven(sites.size());
    }
  }

  @BeforeAll
  static void readRows() {
    Map<String, Points> sets = new HashMap<>();
    SharedData.lines("site-optimum-sets.txt")
        .map(line -> line.strip().split(" ", 3))
        .forEach(words -> sets.put(words[0], points(words[2])));
    for (String[] cells : SharedData.table("site-optimum.tsv", "\t")) {
      Points points = sets.containsKey(cells[0]) ? sets.get(cells[0]) : lattice(cells[0]);
      assertThat(points.size()).as(cells[0]).isEqualTo(Integer.parseInt(cells[1]));
      boolean proven = cells[5].equals("yes");
      ROWS.add(
          new Row(cells[0], Sites.of(points, Progress.NONE), Integer.parseInt(cells[4]), proven));
    }
  }

  private static Points points(String numbers) {
    return Points.ofPairs(Stream.of(numbers.split(" ")).mapToDouble(Double::parseDouble).toArray());
  }

  /** All whole points of a rectangle, from a name like {@code lattice3x4}. */
  private static Points lattice(String name) {
    String[] sides = name.substring("lattice".length()).split("x", 2);
    int columns = Integer.parseInt(sides[0]);
    double[] pairs = new double[2 * columns * Integer.parseInt(sides[1])];
    for (int i = 0; i < pairs.length; i += 2) {
      pairs[i] = Math.floorMod(i / 2, columns);
      pairs[i + 1] = Math.floorDiv(i / 2, columns);
    }
    return Points.ofPairs(pairs);
  }

  @Test
  void refutedSetsOfOddVerticesProveEveryOptimum() {
    int proven = 0;
    for (Row row : ROWS) {
      if (row.proven && row.sites.size() <= MOST_REFUTED) {
        Optimum known = Optimum.of(row.start(), row.goal(), new LowerBound(0, "handshake lemma"));
        Optimum better =
            OddSetProof.begin(row.start(), row.goal(), Progress.NONE)
                .orElseThrow()
                .improve(known, OddSetProof.STEPS);
        TriangulationAssert.assertThat(better.triangulation()).isTriangulationOf(row.sites);
        assertThat(better.unmet()).as(row.name).isEqualTo(row.least);
        assertThat(better.isProven()).as(row.name).isTrue();
        proven++;
      }
    }
    assertThat(proven).isGreaterThan(100);
  }

  /** The figures of {@code docs/optimum.md}. */
  @Test
  void windowsAloneProveAllButOneOptimum() {
    List<String> less = new ArrayList<>();
    int equal = 0;
    for (Row row : ROWS) {
      if (row.proven && row.sites.size() <= MOST_IN_WINDOWS && isSpanned(row)) {
        int value = SiteBounds.ofWindows(row.start(), row.goal(), Progress.NONE).value();
        assertThat(value).as(row.name).isLessThanOrEqualTo(row.least);
        equal += value == row.least ? 1 : 0;
        if (value < row.least) {
          less.add(row.name);
        }
      }
    }
    assertThat(less).containsExactly("run12_4");
    assertThat(equal).isEqualTo(156);
  }

  private static boolean isSpanned(Row row) {
    return row.start().triangleCount() > 0;
  }

  @Test
  void everyProvenOptimumOfFewSitesIsReached() {
    int solved = 0;
    for (Row row : ROWS) {
      if (row.proven && ExactSites.canSolve(row.start())) {
        Optimum optimum = ExactSites.optimize(row.start(), row.goal(), Progress.NONE);
        TriangulationAssert.assertThat(optimum.triangulation()).isTriangulationOf(row.sites);
        assertThat(DegreeCount.of(optimum.triangulation()).odd())
            .as(row.name)
            .isEqualTo(row.least)
            .isEqualTo(optimum.bound().value());
        solved++;
      }
    }
    assertThat(solved).isGreaterThan(100);
  }

  @Test
  void noBoundIsAboveAnOptimumAndEachDecidesItsShare() {
    Map<String, Integer> decided = new TreeMap<>();
    List<String> open = new ArrayList<>();
    for (Row row : ROWS) {
      HullRing ring = HullRing.of(row.start());
      single(ring, row.goal()).forEach((name, value) -> count(decided, name, row, value));
      int best = SiteBounds.of(row.start(), row.goal(), Progress.NONE).value();
      count(decided, "best of all", row, best);
      if (best < row.least) {
        open.add(row.name + " " + best + "–" + row.least);
      }
    }
    assertThat(open).hasSizeLessThan(ROWS.size() / 4);
    assertThat(decided.get("best of all")).isGreaterThan(100);
    assertThat(decided.get("hull walk")).isGreaterThan(decided.get("boundary"));
    assertThat(decided.get("lattice")).isPositive();
  }

  private static Map<String, Integer> single(HullRing ring, ParityGoal goal) {
    Map<String, Integer> values = new TreeMap<>();
    values.put("boundary", BoundaryColouring.ofSites(ring, goal).value());
    values.put("degree sum", DegreeSumBound.of(ring, goal).value());
    values.put("long side", LongSideBound.of(ring, goal).value());
    values.put("lattice", LatticeBound.of(ring, goal, Progress.NONE).value());
    values.put("three hull sites", ThreeHullSites.of(ring, goal, 0).value());
    values.put(
        "strips",
        HullWalkBound.ofStrips(ring, goal, Progress.NONE).map(LowerBound::value).orElse(0));
    values.put(
        "hull walk",
        HullWalkBound.ofWalk(ring, goal, -1, Progress.NONE).map(LowerBound::value).orElse(0));
    Handshake handshake = new Handshake(goal);
    values.replaceAll((name, value) -> handshake.roundUp(Math.max(0, value)));
    return values;
  }

  private static void count(Map<String, Integer> decided, String name, Row row, int value) {
    decided.merge(name, value == row.least ? 1 : 0, Integer::sum);
    decided.merge(name + " (least > 0)", value == row.least && value > 0 ? 1 : 0, Integer::sum);
    assertThat(value).as("%s: %s", row.name, name).isLessThanOrEqualTo(row.least);
  }
}
