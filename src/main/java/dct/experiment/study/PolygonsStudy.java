package dct.experiment.study;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.HertelMehlhorn;
import dct.core.triangulate.MonotoneTriangulation;
import dct.experiment.generate.PolygonShape;
import dct.problem.Instance;
import dct.render.chart.Chart;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The experiment on polygons that the thesis left open for want of random polygons (its Section
 * 4.4): the even vertices of three triangulations, each also after Scan-Flip, and the most that any
 * triangulation has, beside the numbers of reflex vertices and of convex pieces.
 */
public final class PolygonsStudy implements Study {
  /** The sizes unless others are asked for. */
  public static final List<Integer> SIZES = List.of(10, 20, 50, 100, 200, 500, 1000);

  /** The number of polygons of each shape and size unless another is asked for. */
  public static final int SETS = 100;

  private final List<Trial> trials;
  private final Map<Trial, Instance.OfPolygon> files;

  /**
   * The study of these polygons.
   *
   * @param plan the random ones
   * @param files real ones, by their names, which come first
   */
  public PolygonsStudy(StudyPlan plan, Map<String, Instance.OfPolygon> files) {
    this.files = new LinkedHashMap<>();
    files.forEach((name, p) -> this.files.put(new Trial(name, p.size(), 1, 0), p));
    trials = new ArrayList<>(this.files.keySet());
    trials.addAll(plan.trials());
  }

  @Override
  public String name() {
    return "polygons";
  }

  @Override
  public List<Trial> trials() {
    return List.copyOf(trials);
  }

  @Override
  public List<String> counts() {
    return PolygonsColumns.all();
  }

  @Override
  public List<String> steps() {
    return OutlineRun.steps();
  }

  @Override
  public double cost(Trial trial) {
    return (double) trial.n() * trial.n(); // the table of the optimum outweighs the rest
  }

  @Override
  public StudyRow run(Trial trial, Progress progress) {
    Laps laps = new Laps();
    Instance.OfPolygon instance = laps.time("generate", () -> instance(trial));
    Map<String, Integer> counts = new LinkedHashMap<>();
    counts.put(PolygonsColumns.REFLEX, reflex(instance.polygon()));
    counts.put(PolygonsColumns.PIECES, pieces(instance.polygon(), progress));
    OutlineRun.count(instance, counts, laps, progress);
    return new StudyRow(trial, counts, laps.millis());
  }

  private Instance.OfPolygon instance(Trial trial) {
    Instance.OfPolygon file = files.get(trial);
    return file != null
        ? file
        : Instance.of(
            trial.shape(),
            PolygonShape.of(trial.shape()).orElseThrow().generate(trial.n(), trial.seed()));
  }

  /** How many vertices have an inner angle of more than 180°. */
  private static int reflex(SimplePolygon polygon) {
    Points points = polygon.points();
    int n = polygon.size();
    int reflex = 0;
    for (int k = 0; k < n; k++) {
      int before = polygon.vertex((k + n - 1) % n);
      int after = polygon.vertex((k + 1) % n);
      reflex += points.orient(before, polygon.vertex(k), after) < 0 ? 1 : 0;
    }
    return reflex;
  }

  /** The number of convex pieces that Partitioning-AQT works with. */
  private static int pieces(SimplePolygon polygon, Progress progress) {
    return HertelMehlhorn.partition(
            polygon, MonotoneTriangulation.triangulate(polygon, progress), progress)
        .pieces();
  }

  @Override
  public List<Table> tables(List<StudyRow> rows) {
    return PolygonsTables.of(rows);
  }

  @Override
  public List<String> chartWords() {
    return PolygonsCharts.WORDS;
  }

  @Override
  public List<Chart> charts(List<StudyRow> rows) {
    return PolygonsCharts.of(rows);
  }

  @Override
  public List<StudyPicture> pictures(Trial trial, Progress progress) {
    return OutlineRun.pictures(instance(trial), progress);
  }
}
