package dct.ui.document;

import dct.core.degree.ParityGoal;
import dct.problem.Solution;
import dct.render.Scene;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;

/**
 * What a named step made of the points of a document; immutable.
 *
 * @param view the number of the view that shows it; a later result of the same view takes its place
 * @param title what was done, for a person to read
 * @param solution the triangulation and what is known of it
 * @param scene the picture of the solution
 * @param time how long it took to make, if that was measured
 */
public record Result(
    int view, String title, Solution solution, Scene scene, Optional<Duration> time) {

  /** The view in which sites are drawn: results of theirs are shown there. */
  public static final int CANVAS = 0;

  /** The view of a polygon's result that came with its file. */
  public static final int OPENED = 1;

  /** A result with its picture, made in linear time. */
  public static Result of(int view, String title, Solution solution) {
    return new Result(view, title, solution, Scene.of(solution), Optional.empty());
  }

  /** The same, made in so much time. */
  public Result taking(Duration measured) {
    return new Result(view, title, solution, scene, Optional.of(measured));
  }

  /** The same triangulation, of vertices with other wishes; see {@link Solution#wishing}. */
  public Result wishing(ParityGoal wishes) {
    return new Result(view, title, solution.wishing(wishes), scene.withoutVerdict(), time);
  }

  /** Whether it cannot be made again at once: it has flips or was searched for. */
  public boolean isWorthKeeping() {
    return solution.flips().isPresent() || solution.optimum().isPresent();
  }

  /** The picture follows from the rest, and how long it took tells nothing. */
  @Override
  public boolean equals(Object other) {
    return other instanceof Result that
        && view == that.view
        && title.equals(that.title)
        && solution.equals(that.solution);
  }

  @Override
  public int hashCode() {
    return Objects.hash(view, title, solution);
  }
}
