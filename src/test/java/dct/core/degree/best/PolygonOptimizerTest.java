package dct.core.degree.best;

import static dct.testing.TriangulationAssert.assertThat;
import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.PartitioningAqt;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.region.PolygonImprover;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.PolygonShape;
import dct.testing.CancelledAfter;
import dct.testing.EveryTriangulation;
import dct.testing.ForeignDataTest;
import dct.testing.RandomPolygons;
import dct.testing.SharedData;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class PolygonOptimizerTest {

  private static Optimum optimize(SimplePolygon polygon, ParityGoal goal) {
    Optimum optimum = BestTriangulation.of(polygon, goal, SearchLimits.DEFAULT, Progress.NONE);
    assertThat(optimum.triangulation()).isTriangulationOf(polygon);
    assertThat(optimum.unmet()).isEqualTo(goal.unmet(optimum.triangulation()));
    return optimum;
  }

  @Test
  void equalsBruteForceForEvenOddAndRandomWishes() {
    for (RandomPolygons.Family family : RandomPolygons.families()) {
      for (int seed = 0; seed < 120; seed++) {
        Random random = new Random(seed);
        Points points = family.maker().make(4 + random.nextInt(8), random);
        if (points.size() <= 11) {
          SimplePolygon polygon = SimplePolygon.of(points, Progress.NONE);
          for (ParityGoal goal : goals(points.size(), random)) {
            Optimum optimum = optimize(polygon, goal);
            assertThat(optimum.unmet())
                .as("%s, seed %d, %d vertices", family, seed, points.size())
                .isEqualTo(fewestByBruteForce(polygon, goal));
            assertThat(optimum.isProven()).isTrue();
          }
        }
      }
    }
  }

  /** What ends at the bound before the table has the table's count, for all wishes even or odd. */
  @Test
  void equalsTheTableForAllWishesOnConvexPolygons() {
    for (int n = 4; n <= 12; n++) {
      SimplePolygon polygon =
          SimplePolygon.of(RandomPolygons.convex(n, new Random(n)), Progress.NONE);
      int size = polygon.size();
      Triangulation any = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
      for (int odd = 0; odd < 1 << size; odd++) {
        Wish[] wishes = new Wish[size];
        for (int v = 0; v < size; v++) {
          wishes[v] = (odd >> v & 1) == 1 ? Wish.ODD : Wish.EVEN;
        }
        ParityGoal goal = ParityGoal.of(wishes);
        Optimum table = PolygonOptimizer.exact(polygon, goal, any, Progress.NONE).orElseThrow();
        assertThat(optimize(polygon, goal).unmet())
            .as("%d vertices, odd %s", size, Integer.toBinaryString(odd))
            .isEqualTo(table.unmet());
      }
    }
  }

  private static List<ParityGoal> goals(int n, Random random) {
    return List.of(ParityGoal.allEven(n), ParityGoal.allOdd(n), randomWishes(n, random));
  }

  private static ParityGoal randomWishes(int n, Random random) {
    Wish[] wishes = new Wish[n];
    for (int v = 0; v < n; v++) {
      wishes[v] = List.of(Wish.values()).get(random.nextInt(3));
    }
    return ParityGoal.of(wishes);
  }

  private static int fewestByBruteForce(SimplePolygon polygon, ParityGoal goal) {
    AtomicInteger fewest = new AtomicInteger(Integer.MAX_VALUE);
    EveryTriangulation.of(
        polygon,
        degrees -> {
          int unmet = 0;
          for (int k = 0; k < degrees.length; k++) {
            boolean satisfied = goal.wish(polygon.vertex(k)).isGrantedBy(degrees[k]);
            unmet += satisfied ? 0 : 1;
          }
          fewest.accumulateAndGet(unmet, Math::min);
        });
    return fewest.get();
  }

  /** Against an independent program's optima of polygons that the generators make again. */
  @Test
  void reachesTheKnownOptimumOfEveryGeneratedPolygon() {
    List<String[]> rows = SharedData.table("polygon-optimum.tsv", "\t");
    assertThat(rows).hasSize(59);
    for (String[] row : rows) {
      PolygonShape shape = PolygonShape.of(row[0]).orElseThrow();
      SimplePolygon polygon = shape.generate(Integer.parseInt(row[1]), Long.parseLong(row[2]));
      Optimum optimum = optimize(polygon, ParityGoal.allEven(polygon.size()));
      assertThat(optimum.unmet()).as("%s", List.of(row)).isEqualTo(Integer.parseInt(row[3]));
      assertThat(optimum.isProven()).isTrue();
    }
  }

  @ForeignDataTest
  void reachesThePublishedOptimumOfEveryPolygon() throws IOException {
    List<Path> files = SharedData.files("polygons");
    Path table = files.get(0).getParent().resolveSibling("polygon-optimum.tsv");
    int compared = 0;
    for (String line : Files.readAllLines(table)) {
      String[] columns = line.split("\t", -1);
      if (columns[0].startsWith("polygons/") && !columns[3].equals("-")) {
        Path file = table.resolveSibling(columns[0]);
        SimplePolygon polygon = SimplePolygon.of(SharedData.read(file), Progress.NONE);
        assertThat(optimize(polygon, ParityGoal.allEven(polygon.size())).unmet())
            .as(columns[0])
            .isEqualTo(Integer.parseInt(columns[3]));
        compared++;
      }
    }
    assertThat(compared).isGreaterThan(60);
  }

  @Test
  void convexPolygonsMeetLemmas32And33() {
    for (int n = 3; n <= 60; n++) {
      SimplePolygon polygon =
          SimplePolygon.of(RandomPolygons.convex(n, new Random(n)), Progress.NONE);
      int size = polygon.size();
      Optimum optimum = optimize(polygon, ParityGoal.allEven(size));
      assertThat(optimum.unmet()).isEqualTo(size % 3 == 0 ? 0 : 2);
      assertThat(optimum.isProven()).isTrue();
    }
  }

  /** Fact 3: with no inner vertices, the arcs between odd vertices alternate to 0 modulo 3. */
  @Test
  void theArcsBetweenOddVerticesAlternateToZeroModuloThree() {
    for (RandomPolygons.Family family : RandomPolygons.families()) {
      for (int seed = 0; seed < 10; seed++) {
        SimplePolygon polygon =
            SimplePolygon.of(family.maker().make(60, new Random(seed)), Progress.NONE);
        Optimum optimum = optimize(polygon, ParityGoal.allEven(polygon.size()));
        assertThat(alternatingArcs(optimum.triangulation()) % 3)
            .as("%s, seed %d", family, seed)
            .isZero();
      }
    }
  }

  private static int alternatingArcs(Triangulation triangulation) {
    int n = triangulation.vertexCount();
    int first = 0;
    while (first < n && triangulation.isEven(first)) {
      first++;
    }
    if (first == n) {
      return n;
    }
    int sum = 0;
    int sign = 1;
    for (int step = 1; step <= n; step++) {
      sum += sign;
      sign = triangulation.isEven((first + step) % n) ? sign : -sign;
    }
    return sum;
  }

  /** The best of what the thesis's own algorithms make of a polygon. */
  private static int thesisBest(SimplePolygon polygon, ParityGoal goal) {
    Triangulation monotone = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    Triangulation pieces = PartitioningAqt.triangulate(polygon, Progress.NONE);
    Triangulation clipped = EarClipping.triangulate(polygon, Progress.NONE);
    return IntStream.of(
            goal.unmet(ScanFlip.run(monotone, Progress.NONE).after()),
            goal.unmet(ScanFlip.run(pieces, Progress.NONE).after()),
            goal.unmet(ScanFlip.run(clipped, Progress.NONE).after()))
        .min()
        .getAsInt();
  }

  @Test
  void theImproverComesWithinOnePercentOfTheOptimum() {
    for (int seed = 0; seed < 3; seed++) {
      Points points = RandomPolygons.starShaped(1500, new Random(seed));
      SimplePolygon polygon = SimplePolygon.of(points, Progress.NONE);
      ParityGoal goal = ParityGoal.allEven(points.size());
      PolygonImprover improver = new PolygonImprover(goal, SearchLimits.DEFAULT, Progress.NONE);
      Triangulation monotone = MonotoneTriangulation.triangulate(polygon, Progress.NONE);

      Triangulation improved = improver.run(monotone, 0);

      assertThat(improved).isTriangulationOf(polygon);
      assertThat(goal.unmet(improved))
          .as("seed %d", seed)
          .isLessThanOrEqualTo(thesisBest(polygon, goal))
          .isLessThanOrEqualTo(optimize(polygon, goal).unmet() + points.size() / 100);
    }
  }

  @Test
  void aTimeLimitThatIsUpGivesTheFirstTriangulation() {
    SimplePolygon polygon =
        SimplePolygon.of(RandomPolygons.starShaped(3000, new Random(1)), Progress.NONE);
    ParityGoal goal = ParityGoal.allEven(polygon.size());
    Optimum byTime = BestTriangulation.of(polygon, goal, new SearchLimits(1, 1, 0), Progress.NONE);
    assertThat(byTime.interrupted()).isTrue();
    assertThat(byTime.triangulation()).isTriangulationOf(polygon);
  }

  /** Whatever the question at which the user cancels: sound, and in the end the thesis's best. */
  @Test
  void aCancelAtAnyQuestionGivesTheBestSoFar() {
    SimplePolygon polygon =
        SimplePolygon.of(RandomPolygons.starShaped(1000, new Random(1)), Progress.NONE);
    Triangulation start = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    ParityGoal goal = ParityGoal.allEven(polygon.size());
    int last = goal.unmet(start);
    for (int questions = 0; questions < 500; questions += 1 + questions / 4) {
      Optimum best = cancelledAfter(questions, polygon, start);
      assertThat(best.unmet()).isLessThanOrEqualTo(last);
      last = best.unmet();
    }
    assertThat(last).isLessThanOrEqualTo(thesisBest(polygon, goal));
  }

  private static Optimum cancelledAfter(int questions, SimplePolygon polygon, Triangulation start) {
    Optimum best =
        BestTriangulation.of(
            polygon,
            start,
            ParityGoal.allEven(polygon.size()),
            SearchLimits.DEFAULT,
            new CancelledAfter(questions));
    assertThat(best.triangulation()).isTriangulationOf(polygon);
    return best;
  }

  @Test
  void aCancelBeforeAnythingIsDoneGivesTheStart() {
    for (Points points :
        List.of(
            RandomPolygons.starShaped(200, new Random(1)),
            RandomPolygons.convex(200, new Random(1)))) {
      SimplePolygon polygon = SimplePolygon.of(points, Progress.NONE);
      Triangulation start = EarClipping.triangulate(polygon, Progress.NONE);
      Optimum best = cancelledAfter(0, polygon, start);
      assertThat(best.triangulation()).isSameAs(start);
      assertThat(best.interrupted()).isTrue();
    }
  }
}
