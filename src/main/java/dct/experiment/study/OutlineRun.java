package dct.experiment.study;

import dct.core.Progress;
import dct.core.degree.Optimum;
import dct.core.degree.SearchLimits;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.render.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** What the studies of polygons and of regions do alike with an instance. */
final class OutlineRun {
  private OutlineRun() {}

  /** The names of the steps whose time is kept. */
  static List<String> steps() {
    List<String> steps = new ArrayList<>(List.of("generate"));
    PolygonsColumns.METHODS.forEach(method -> steps.add(method.column()));
    steps.add("best");
    return steps;
  }

  /**
   * Counts the even vertices of each method, before and after Scan-Flip, and of the best
   * triangulation.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static void count(Instance instance, Map<String, Integer> counts, Laps laps, Progress progress) {
    for (Method method : PolygonsColumns.METHODS) {
      Solution made = laps.time(method.column(), () -> Solution.of(instance, method, progress));
      counts.put(PolygonsColumns.before(method), made.counts().even());
      counts.put(PolygonsColumns.after(method), made.flipped(progress).counts().even());
    }
    Optimum best = laps.time("best", () -> best(instance, progress));
    progress.checkCancelled(); // what a search found until then is no row
    counts.put(StudyRow.BEST, instance.size() - best.unmet());
    counts.put(StudyRow.LIMIT, instance.size() - best.bound().value());
  }

  private static Optimum best(Instance instance, Progress progress) {
    return Solution.of(instance, Method.MONOTONE, progress)
        .optimized(SearchLimits.DEFAULT, progress)
        .optimum()
        .orElseThrow();
  }

  /**
   * Partitioning-AQT, the same with Scan-Flip, and the best triangulation.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static List<StudyPicture> pictures(Instance instance, Progress progress) {
    Solution aqt = Solution.of(instance, Method.CONVEX_EVEN, progress);
    String title = Method.CONVEX_EVEN.algorithm();
    return List.of(
        new StudyPicture(title, Scene.of(aqt)),
        new StudyPicture(title + " and Scan-Flip", Scene.of(aqt.flipped(progress))),
        new StudyPicture("Best", Scene.of(aqt.optimized(SearchLimits.DEFAULT, progress))));
  }
}
