package dct.core.triangulate;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.dcel.DcelValidator;
import dct.core.degree.DegreeCount;
import dct.core.degree.FlipResult;
import dct.core.degree.ScanFlip;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.testing.ForeignDataTest;
import dct.testing.RandomSets;
import dct.testing.RandomSets.Family;
import dct.testing.SharedData;
import dct.testing.Transforms;
import dct.testing.TriangulationAssert;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.IntStream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Delaunay, and Scan-Flip after it, on sites of many kinds.
 *
 * <pre>
 * Points points = Points.ofPairs(0, 0, 4, 0, 4, 4, 0, 4, 2, 1);
 * Sites sites = Sites.of(points, Progress.NONE);
 * Triangulation delaunay = Delaunay.triangulate(sites, Progress.NONE);
 * delaunay.triangleCount(); // 4
 * delaunay.degree(4); // 4: the inner site
 * </pre>
 */
class DelaunayTest {

  @Test
  void theExample() {
    Points points = Points.ofPairs(0, 0, 4, 0, 4, 4, 0, 4, 2, 1);
    Sites sites = Sites.of(points, Progress.NONE);
    Triangulation delaunay = Delaunay.triangulate(sites, Progress.NONE);
    assertThat(delaunay.triangleCount()).isEqualTo(4);
    assertThat(delaunay.degree(4)).isEqualTo(4);
  }

  static List<Family> families() {
    return RandomSets.families();
  }

  @ParameterizedTest
  @MethodSource("families")
  void manySmallSets(Family family) {
    for (int seed = 0; seed < (isSlow(family) ? 80 : 300); seed++) {
      check(family, 1 + seed % 40, seed);
    }
  }

  @ParameterizedTest
  @MethodSource("families")
  void someLargerSets(Family family) {
    int most = isSlow(family) ? 1 : 4;
    for (int seed = 0; seed < most; seed++) {
      check(family, 150 << seed, seed);
    }
  }

  @ParameterizedTest
  @MethodSource("families")
  void allImagesAndScales(Family family) {
    for (int seed = 1000; seed < (isSlow(family) ? 1001 : 1006); seed++) {
      Points p = family.make(15 + seed % 9, seed).points();
      String what = family + ", seed " + seed + ", ";
      for (Transforms.Named image : Transforms.all(p)) {
        checkAll(image.points(), what + image);
      }
      if (!isSlow(family)) {
        for (Transforms.Named image : Transforms.scales(p)) {
          checkAll(image.points(), what + image);
        }
      }
    }
  }

  /** Whether every decision takes decimals of a thousand digits; nothing fits another scale. */
  private static boolean isSlow(Family family) {
    return family.name().startsWith("wide range") || family.name().startsWith("least");
  }

  private static void check(Family family, int n, int seed) {
    Sites sites = family.make(n, seed);
    checkAll(sites.points(), "%s, n %d, seed %d".formatted(family, n, seed));
  }

  private static void checkAll(Points points, String what) {
    Sites sites = Sites.of(points, Progress.NONE);
    Triangulation delaunay = Delaunay.triangulate(sites, Progress.NONE);
    TriangulationAssert.assertThat(delaunay)
        .as(what)
        .isTriangulationOf(sites)
        .isDelaunay()
        .hasInnerEdgesOnlyOf(EdgeKind.DIAGONAL);
    FlipResult result = ScanFlip.run(delaunay, Progress.NONE);
    TriangulationAssert.assertThat(result.after())
        .as("flipped, %s", what)
        .isTriangulationOf(sites)
        .hasInnerEdgesOnlyOf(EdgeKind.DIAGONAL, EdgeKind.FLIPPED);
    int gain = DegreeCount.of(result.after()).even() - DegreeCount.of(delaunay).even();
    assertThat(gain).as(what).isBetween(2 * result.flips(), 4 * result.flips());
    assertThat(result.after().count(EdgeKind.FLIPPED)).as(what).isEqualTo(result.flips());
  }

  @Test
  void noneToThreeSites() {
    assertThat(edges()).isEmpty();
    assertThat(edges(5, 7)).isEmpty();
    assertThat(edges(5, 7, 1, 2)).containsExactly("0–1");
    assertThat(edges(0, 0, 4, 0, 0, 4)).containsExactly("0–1", "0–2", "1–2");
    assertThat(edges(0, 0, 0, 4, 4, 0)).containsExactly("0–1", "0–2", "1–2");
    assertThat(edges(0, 0, 4, 4, 2, 2)).containsExactly("0–2", "1–2");
  }

  @Test
  void sitesOnALineGiveThePathAlongIt() {
    assertThat(edges(3, 0, 1, 0, 2, 0, 9, 0)).containsExactly("0–2", "0–3", "1–2");
    assertThat(edges(0, 3, 0, 1, 0, 2, 0, 9)).containsExactly("0–2", "0–3", "1–2");
    Triangulation path =
        Delaunay.triangulate(
            Sites.of(Points.ofPairs(0, 0, 2, 2, 1, 1), Progress.NONE), Progress.NONE);
    assertThat(path.triangleCount()).isZero();
    assertThat(path.triangles()).isEmpty();
    assertThat(ScanFlip.run(path, Progress.NONE).flips()).isZero();
  }

  private static List<String> edges(double... pairs) {
    Triangulation t =
        Delaunay.triangulate(Sites.of(Points.ofPairs(pairs), Progress.NONE), Progress.NONE);
    DcelValidator.validate(t.dcel());
    String[] names = new String[t.edgeCount()];
    for (int e = 0; e < names.length; e++) {
      names[e] = Math.min(t.from(e), t.to(e)) + "–" + Math.max(t.from(e), t.to(e));
    }
    Arrays.sort(names);
    return List.of(names);
  }

  @Test
  void duplicatesAreMergedIntoTheFirst() {
    Sites sites = Sites.of(Points.ofPairs(4, 0, 0, 0, 4, 0, 0, 4, -0.0, 0, 4, 0), Progress.NONE);
    assertThat(sites.merged()).isEqualTo(3);
    assertThat(sites.points()).isEqualTo(Points.ofPairs(4, 0, 0, 0, 0, 4));
    checkAll(sites.points(), "with duplicates");
  }

  /** The parts are triangulated in parallel; the result is the same with one thread. */
  @Test
  void theNumberOfThreadsMakesNoDifference() throws Exception {
    for (Family family : families().subList(0, 6)) {
      Sites sites = family.make(30_000, 1);
      List<String> many = edges(Delaunay.triangulate(sites, Progress.NONE));
      ForkJoinPool one = new ForkJoinPool(1);
      List<String> single =
          one.submit(() -> edges(Delaunay.triangulate(sites, Progress.NONE))).get();
      one.shutdown();
      assertThat(single).as("%s", family).isEqualTo(many);
    }
  }

  /** In the order of their numbers. */
  private static List<String> edges(Triangulation t) {
    return IntStream.range(0, t.edgeCount()).mapToObj(e -> t.from(e) + "–" + t.to(e)).toList();
  }

  @Test
  void thousandsOfSites() {
    for (Family family : families()) {
      if (!isSlow(family)) {
        check(family, 20_000, 1);
      }
    }
  }

  @TestFactory
  List<DynamicTest> everySample() {
    List<Path> samples = SharedData.samples("pointbased");
    assertThat(samples).hasSizeGreaterThanOrEqualTo(5);
    return samples.stream().map(DelaunayTest::onAllImages).toList();
  }

  private static DynamicTest onAllImages(Path file) {
    return DynamicTest.dynamicTest(
        file.getFileName().toString(),
        () -> {
          for (Transforms.Named image : Transforms.all(SharedData.read(file))) {
            checkAll(image.points(), file + ", " + image);
          }
        });
  }

  @ForeignDataTest
  void everySharedSet() {
    List<Path> files = SharedData.files("points");
    assertThat(files).hasSizeGreaterThan(50);
    for (Path file : files) {
      checkAll(SharedData.read(file), file.getFileName().toString());
    }
  }
}
