package dct.ui.result;

import dct.core.degree.FlipResult;
import dct.problem.Instance;
import dct.problem.Solution;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import dct.ui.document.Result;
import dct.ui.document.ResultTitle;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The results of the points that an editor has now, from the oldest on; first of all the Delaunay
 * triangulation of sites. Of flips that follow each other by hand the last one counts.
 */
public final class ResultList {
  private Optional<Result> delaunay = Optional.empty(); // it is no step of the history

  /** The results, in linear time. */
  public List<Result> of(Editor editor) {
    Document document = editor.document();
    if (!editor.shown().document().isDrawnAs(document)) {
      return List.of(); // they are still being looked at
    }
    delaunay = editor.shown().delaunay().map(this::asResult);
    List<Result> results = new ArrayList<>();
    delaunay.ifPresent(results::add);
    editor.history().made().stream()
        .filter(result -> isOf(result.solution().instance(), document))
        .forEach(result -> add(results, result));
    document.result().ifPresent(present -> add(results, present));
    return results;
  }

  /** Of sites at one place only one is triangulated. */
  private boolean isOf(Instance instance, Document document) {
    return delaunay
        .map(result -> result.solution().instance().points().equals(instance.points()))
        .orElseGet(() -> document.isOf(instance));
  }

  /** The one from before, if it is the same. */
  private Result asResult(Solution solution) {
    return delaunay
        .filter(known -> isSame(known.solution(), solution))
        .orElseGet(() -> Result.of(Result.CANVAS, ResultTitle.of(solution), solution));
  }

  private static boolean isSame(Solution known, Solution other) {
    return known.triangulation().equals(other.triangulation())
        && known.instance().wishes().equals(other.instance().wishes());
  }

  private static void add(List<Result> results, Result result) {
    int last = results.size() - 1;
    if (last >= 0 && isSuperseded(results.get(last), result)) {
      results.set(last, result);
    } else {
      results.add(result);
    }
  }

  /** Whether the second is the first one, with other wishes or after more flips by hand. */
  private static boolean isSuperseded(Result first, Result second) {
    Solution before = first.solution();
    Solution after = second.solution();
    return first.view() == second.view()
        && (before.triangulation().equals(after.triangulation()) || isOfSameFlips(before, after));
  }

  private static boolean isOfSameFlips(Solution before, Solution after) {
    return before.flips().isPresent()
        && before.flips().map(FlipResult::before).equals(after.flips().map(FlipResult::before));
  }
}
