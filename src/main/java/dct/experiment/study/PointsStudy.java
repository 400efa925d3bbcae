package dct.experiment.study;

import dct.core.Progress;
import dct.core.degree.Optimum;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.SiteShape;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.render.Scene;
import dct.render.chart.Chart;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The thesis's experiment on sites (its Section 4.4), carried on: the even vertices of the Delaunay
 * triangulation, after Scan-Flip, after Scan-Flip repeated until it flips nothing more, and of the
 * best triangulation that can be found, beside the most that is not ruled out by a proven bound.
 */
public final class PointsStudy implements Study {
  private static final List<String> STEPS = List.of("delaunay", "scan_flip", "repeated", "best");

  private final StudyPlan plan;

  /** The study of these trials; the shapes are words of generators of sites. */
  public PointsStudy(StudyPlan plan) {
    this.plan = plan;
  }

  @Override
  public String name() {
    return "points";
  }

  @Override
  public List<Trial> trials() {
    return plan.trials();
  }

  @Override
  public List<String> counts() {
    return PointsColumns.ALL;
  }

  @Override
  public List<String> steps() {
    return STEPS;
  }

  @Override
  public double cost(Trial trial) {
    return trial.n();
  }

  @Override
  public StudyRow run(Trial trial, Progress progress) {
    Laps laps = new Laps();
    Instance sites = instance(trial, progress);
    Solution delaunay =
        laps.time(STEPS.get(0), () -> Solution.of(sites, Method.DELAUNAY, progress));
    Solution once = laps.time(STEPS.get(1), () -> delaunay.flipped(progress));
    Repeated often = laps.time(STEPS.get(2), () -> Repeated.of(once, progress));
    Optimum best = laps.time(STEPS.get(3), () -> best(delaunay, progress).optimum().orElseThrow());
    progress.checkCancelled(); // what a search found until then is no row
    Map<String, Integer> counts = new LinkedHashMap<>();
    counts.put(PointsColumns.HULL, delaunay.triangulation().boundaryCount());
    counts.put(PointsColumns.BEFORE, delaunay.counts().even());
    counts.put(PointsColumns.AFTER, once.counts().even());
    counts.put(PointsColumns.FLIPS, flips(once));
    counts.put(PointsColumns.REPEATED, often.last().counts().even());
    counts.put(PointsColumns.REPEATED_FLIPS, often.flips());
    counts.put(PointsColumns.SCANS, often.scans());
    counts.put(StudyRow.BEST, sites.size() - best.unmet());
    counts.put(StudyRow.LIMIT, sites.size() - best.bound().value());
    return new StudyRow(trial, counts, laps.millis());
  }

  private static Instance instance(Trial trial, Progress progress) {
    Points points = SiteShape.of(trial.shape()).orElseThrow().generate(trial.n(), trial.seed());
    return Instance.of(Domain.SITES, trial.shape(), points, progress);
  }

  private static Solution best(Solution delaunay, Progress progress) {
    return delaunay.optimized(SearchLimits.DEFAULT, progress);
  }

  private static int flips(Solution scanned) {
    return scanned.flips().orElseThrow().flips();
  }

  @Override
  public List<Table> tables(List<StudyRow> rows) {
    return PointsTables.of(rows);
  }

  @Override
  public List<String> chartWords() {
    return PointsCharts.WORDS;
  }

  @Override
  public List<Chart> charts(List<StudyRow> rows) {
    return PointsCharts.of(rows);
  }

  @Override
  public List<StudyPicture> pictures(Trial trial, Progress progress) {
    Solution delaunay = Solution.of(instance(trial, progress), Method.DELAUNAY, progress);
    return List.of(
        new StudyPicture("Delaunay", Scene.of(delaunay)),
        new StudyPicture("Scan-Flip", Scene.of(delaunay.flipped(progress))),
        new StudyPicture("Best", Scene.of(best(delaunay, progress))));
  }

  /**
   * Scan-Flip again and again, until a scan flips nothing.
   *
   * @param last the last scan that flipped something
   * @param flips of all scans
   * @param scans how many flipped something
   */
  private record Repeated(Solution last, int flips, int scans) {

    /** Goes on from the first scan. Ends, for each flip makes two vertices even or more. */
    static Repeated of(Solution first, Progress progress) {
      Solution last = first;
      int flips = PointsStudy.flips(first);
      int scans = flips > 0 ? 1 : 0;
      boolean isDone = scans == 0;
      while (!isDone) {
        Solution following = last.flipped(progress); // tells of the flips before, too
        int more = PointsStudy.flips(following) - flips;
        isDone = more == 0;
        if (!isDone) {
          last = following;
          flips += more;
          scans++;
        }
      }
      return new Repeated(last, flips, scans);
    }
  }
}
