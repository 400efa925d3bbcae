package dct.bench;

import dct.core.Progress;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.Preference;
import dct.core.degree.region.ParityTable;
import dct.core.degree.region.PreferredPolygonTable;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.core.triangulate.VisibilityGraph;
import dct.experiment.generate.PolygonShape;
import java.io.PrintStream;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * What a preference costs: the time to fill the table of one cost, and the tables of two, for a
 * polygon of each shape, in turn, the least of several rounds.
 *
 * <pre>PreferenceTimes [vertices, 1000 if absent] [rounds, 15 if absent]</pre>
 */
public final class PreferenceTimes {
  private final PrintStream out;
  private final int rounds;

  private PreferenceTimes(PrintStream out, int rounds) {
    this.out = out;
    this.rounds = rounds;
  }

  /** Prints the table. */
  public static void main(String[] args) {
    int n = args.length > 0 ? Integer.parseInt(args[0]) : 1000;
    int rounds = args.length > 1 ? Integer.parseInt(args[1]) : 15;
    PreferenceTimes times = new PreferenceTimes(System.out, rounds);
    times.warmUp();
    times.out.println("| shape | pairs | even alone, ms | `angle` | `length` | `kept` |");
    times.out.println("|---|---|---|---|---|---|");
    for (PolygonShape shape : PolygonShape.values()) {
      times.row(shape, n);
    }
  }

  private void warmUp() {
    times(PolygonShape.CONVEX.generate(300, 1));
    times(PolygonShape.STAR_SHAPED.generate(1000, 1));
  }

  private void row(PolygonShape shape, int n) {
    SimplePolygon polygon = shape.generate(n, 1);
    double[] millis = times(polygon);
    out.printf(
        Locale.ROOT,
        "| %s | %d | %.3g | %.2f × | %.2f × | %.2f × |%n",
        shape.word(),
        graph(polygon).pairs(),
        millis[0],
        millis[1] / millis[0],
        millis[2] / millis[0],
        millis[3] / millis[0]);
  }

  private static VisibilityGraph graph(SimplePolygon polygon) {
    return VisibilityGraph.of(polygon, any(polygon), Integer.MAX_VALUE, Progress.NONE);
  }

  private static Triangulation any(SimplePolygon polygon) {
    return MonotoneTriangulation.triangulate(polygon, Progress.NONE);
  }

  /** Milliseconds of the table without a preference, and with each. */
  private double[] times(SimplePolygon polygon) {
    VisibilityGraph graph = graph(polygon);
    Wish[] wishes = new Wish[polygon.size()];
    Arrays.fill(wishes, Wish.EVEN);
    List<Preference> preferences =
        List.of(Preference.ANGLE, Preference.LENGTH, Preference.keeping(any(polygon)));
    double[] least = new double[preferences.size() + 1];
    Arrays.fill(least, Double.POSITIVE_INFINITY);
    for (int round = 0; round < rounds; round++) {
      time(
          least,
          0,
          () -> ParityTable.fill(graph, ParityTable.costs(wishes), new int[0], Progress.NONE));
      for (int i = 0; i < preferences.size(); i++) {
        Preference each = preferences.get(i);
        time(
            least,
            i + 1,
            () -> PreferredPolygonTable.fill(polygon, wishes, graph, each, Progress.NONE));
      }
    }
    return least;
  }

  private static void time(double[] least, int which, Runnable work) {
    long start = System.nanoTime();
    work.run();
    least[which] = Math.min(least[which], (System.nanoTime() - start) * 1e-6);
  }
}
