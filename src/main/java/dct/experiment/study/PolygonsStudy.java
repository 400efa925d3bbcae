package dct.experiment.study;

import dct.core.Progress;
import dct.core.degree.DegreeCount;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.PartitioningAqt;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.best.BestTriangulation;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.HertelMehlhorn;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.PolygonShape;
import dct.render.Scene;
import dct.render.chart.Chart;
import java.util.ArrayList;
import java.util.Arrays;
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

  static final String REFLEX = "reflex";
  static final String PIECES = "pieces";
  static final String BEST = "even_best";
  static final String LIMIT = "even_limit";

  /** A way to triangulate that is studied, also with Scan-Flip after it. */
  enum Method {
    EAR_CLIPPING("ear_clipping", "Ear clipping"),
    MONOTONE("monotone", "Monotone"),
    AQT("partitioning_aqt", "Partitioning-AQT");

    private final String word;
    private final String title;

    Method(String word, String title) {
      this.word = word;
      this.title = title;
    }

    private Triangulation run(SimplePolygon polygon, Progress progress) {
      return switch (this) {
        case EAR_CLIPPING -> EarClipping.triangulate(polygon, progress);
        case MONOTONE -> MonotoneTriangulation.triangulate(polygon, progress);
        case AQT -> PartitioningAqt.triangulate(polygon, progress);
      };
    }

    /** Its name for people. */
    String title() {
      return title;
    }

    /** The name of the number of even vertices before Scan-Flip. */
    String before() {
      return "even_" + word;
    }

    /** The name of the number of even vertices after Scan-Flip. */
    String after() {
      return "even_" + word + "_flip";
    }
  }

  private final List<Trial> trials;
  private final Map<Trial, SimplePolygon> files;

  /**
   * The study of these polygons.
   *
   * @param plan the random ones
   * @param files real ones, by their names, which come first
   */
  public PolygonsStudy(StudyPlan plan, Map<String, SimplePolygon> files) {
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
    List<String> counts = new ArrayList<>(List.of(REFLEX, PIECES));
    for (Method method : Method.values()) {
      counts.add(method.before());
      counts.add(method.after());
    }
    counts.addAll(List.of(BEST, LIMIT));
    return counts;
  }

  @Override
  public List<String> steps() {
    List<String> steps = new ArrayList<>(List.of("generate"));
    Arrays.stream(Method.values()).forEach(method -> steps.add(method.word));
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
    SimplePolygon polygon = laps.time("generate", () -> polygon(trial));
    Map<String, Integer> counts = new LinkedHashMap<>();
    counts.put(REFLEX, reflex(polygon));
    counts.put(PIECES, pieces(polygon, progress));
    for (Method method : Method.values()) {
      Triangulation made = laps.time(method.word, () -> method.run(polygon, progress));
      counts.put(method.before(), DegreeCount.of(made).even());
      counts.put(method.after(), DegreeCount.of(ScanFlip.run(made, progress).after()).even());
    }
    Optimum best = laps.time("best", () -> best(polygon, progress));
    progress.checkCancelled(); // what a search found until then is no row
    counts.put(BEST, polygon.size() - best.unsatisfied());
    counts.put(LIMIT, polygon.size() - best.bound().value());
    return new StudyRow(trial, counts, laps.millis());
  }

  private SimplePolygon polygon(Trial trial) {
    SimplePolygon file = files.get(trial);
    return file != null
        ? file
        : PolygonShape.of(trial.shape()).orElseThrow().generate(trial.n(), trial.seed());
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

  private static Optimum best(SimplePolygon polygon, Progress progress) {
    ParityGoal even = ParityGoal.allEven(polygon.size());
    return BestTriangulation.of(polygon, even, SearchLimits.DEFAULT, progress);
  }

  /** Whether the row belongs to a file. */
  static boolean isFile(StudyRow row) {
    return row.trial().seed() == 0;
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
    SimplePolygon polygon = polygon(trial);
    Triangulation aqt = PartitioningAqt.triangulate(polygon, progress);
    return List.of(
        new StudyPicture(Method.AQT.title(), Scene.of(aqt)),
        new StudyPicture(
            Method.AQT.title() + " and Scan-Flip", Scene.of(ScanFlip.run(aqt, progress))),
        new StudyPicture("Best", Scene.of(best(polygon, progress))));
  }
}
