package dct.core.degree.region;

import static dct.testing.TriangulationAssert.assertThat;
import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.dcel.Dcel;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.core.triangulate.VisibilityGraph;
import dct.testing.EveryTriangulation;
import dct.testing.RandomPolygons;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Both kinds of the table over chords, {@link RegionTable} and {@link ParityTable}. */
class ChordTableTest {

  private static final int UNIT = 1000; // of a cost, against noise
  private static final int[] NO_NOISE = {};

  /** A square whose corners shall all be even: either diagonal leaves two of them odd. */
  @Test
  void an_example() {
    SimplePolygon square =
        SimplePolygon.of(
            Points.of(new double[] {0, 1, 1, 0}, new double[] {0, 0, 1, 1}), Progress.NONE);
    Wish[] wishes = {Wish.EVEN, Wish.EVEN, Wish.EVEN, Wish.EVEN};
    ParityTable table =
        ParityTable.fill(graph(square), ParityTable.costs(wishes), NO_NOISE, Progress.NONE);
    assertThat(table.fewest()).isEqualTo(2);
  }

  private static VisibilityGraph graph(SimplePolygon polygon) {
    Triangulation any = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    return VisibilityGraph.of(polygon, any, Integer.MAX_VALUE, Progress.NONE);
  }

  /** Random costs stand for every wish with every parity outside. */
  @Test
  void the_least_cost_is_that_of_the_best_of_all_triangulations() {
    for (RandomPolygons.Family family : RandomPolygons.families()) {
      for (int seed = 0; seed < 60; seed++) {
        Random random = new Random(seed);
        Points points = family.maker().make(3 + random.nextInt(8), random);
        SimplePolygon polygon = SimplePolygon.of(points, Progress.NONE);
        if (polygon.size() <= 11) {
          int[] costs = random.ints(2L * polygon.size(), 0, 4).map(c -> UNIT * c).toArray();
          int least = leastByEnumeration(polygon, costs);
          ParityTable large = ParityTable.fill(graph(polygon), costs, NO_NOISE, Progress.NONE);
          assertThat(large.fewest()).as("%s, seed %d", family, seed).isEqualTo(least);
          assertThat(smallTable(polygon, costs, seed).fewest() / UNIT * UNIT)
              .as("%s, seed %d", family, seed)
              .isEqualTo(least);
        }
      }
    }
  }

  private static int leastByEnumeration(SimplePolygon polygon, int[] costs) {
    int[] least = {Integer.MAX_VALUE};
    EveryTriangulation.of(
        polygon,
        degrees -> {
          int cost = 0;
          for (int k = 0; k < degrees.length; k++) {
            cost += costs[2 * k + ((degrees[k] - 1) & 1)]; // one triangle fewer than edges
          }
          least[0] = Math.min(least[0], cost);
        });
    return least[0];
  }

  private static RegionTable smallTable(SimplePolygon polygon, int[] costs, int noiseSeed) {
    int n = polygon.size();
    double[] x = new double[n];
    double[] y = new double[n];
    for (int k = 0; k < n; k++) {
      x[k] = polygon.points().x(polygon.vertex(k));
      y[k] = polygon.points().y(polygon.vertex(k));
    }
    Triangulation any = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    SearchMesh mesh = new SearchMesh(any, ParityGoal.allEven(n), UNIT, Progress.NONE);
    RegionTable table = new RegionTable(mesh, x, y, costs, Math.max(n, 8));
    table.solve(n, 1, noiseSeed);
    return table;
  }

  @Test
  void the_triangulation_cut_has_the_least_cost_also_with_noise() {
    SeededRandom random = new SeededRandom(4);
    for (RandomPolygons.Family family : RandomPolygons.families()) {
      Points points = family.maker().make(200, new Random(2));
      SimplePolygon polygon = SimplePolygon.of(points, Progress.NONE);
      int n = polygon.size();
      VisibilityGraph graph = graph(polygon);
      int[] costs = new int[2 * n];
      Arrays.setAll(costs, i -> 20 * n * random.nextInt(3));
      int[] noise = new int[graph.pairs()];
      Arrays.setAll(noise, pair -> random.nextInt(16));
      int[] corner = new int[n];
      Arrays.setAll(corner, k -> 2 * k);
      Dcel dcel = Dcel.cycle(polygon.walk());
      ParityTable table = ParityTable.fill(graph, costs, noise, Progress.NONE);
      table.cut(dcel, corner);
      Triangulation cut =
          new Triangulation(Domain.POLYGON, points, dcel, edge -> EdgeKind.DIAGONAL);
      assertThat(cut).isTriangulationOf(polygon);
      int cost = 0;
      for (int k = 0; k < n; k++) {
        cost += costs[2 * k + ((cut.degree(polygon.vertex(k)) - 1) & 1)];
      }
      int without = ParityTable.fill(graph, costs, NO_NOISE, Progress.NONE).fewest();
      assertThat(cost).as("%s", family).isEqualTo(without);
      assertThat(table.fewest()).isBetween(without, without + 16 * n);
    }
  }
}
