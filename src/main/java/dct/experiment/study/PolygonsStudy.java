package dct.experiment.study;

import dct.core.Progress;
import dct.core.degree.Optimum;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.HertelMehlhorn;
import dct.core.triangulate.MonotoneTriangulation;
import dct.experiment.generate.PolygonShape;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.render.Scene;
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
    List<String> steps = new ArrayList<>(List.of("generate"));
    PolygonsColumns.METHODS.forEach(method -> steps.add(method.column()));
    steps.add("best");
    return steps;
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
    for (Method method : PolygonsColumns.METHODS) {
      Solution made = laps.time(method.column(), () -> Solution.of(instance, method, progress));
      counts.put(PolygonsColumns.before(method), made.counts().even());
      counts.put(PolygonsColumns.after(method), made.flipped(progress).counts().even());
    }
    Optimum best = laps.time("best", () -> best(instance, progress));
    progress.checkCancelled(); // what a search found until then is no row
    counts.put(StudyRow.BEST, instance.size() - best.unmet());
    counts.put(StudyRow.LIMIT, instance.size() - best.bound().value());
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

  private static Optimum best(Instance instance, Progress progress) {
    return Solution.of(instance, Method.MONOTONE, progress)
        .optimized(SearchLimits.DEFAULT, progress)
        .optimum()
        .orElseThrow();
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
    Solution aqt = Solution.of(instance(trial), Method.CONVEX_EVEN, progress);
    String title = Method.CONVEX_EVEN.algorithm();
    return List.of(
        new StudyPicture(title, Scene.of(aqt)),
        new StudyPicture(title + " and Scan-Flip", Scene.of(aqt.flipped(progress))),
        new StudyPicture("Best", Scene.of(aqt.optimized(SearchLimits.DEFAULT, progress))));
  }
}
