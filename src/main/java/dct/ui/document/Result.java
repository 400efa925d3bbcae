package dct.ui.document;

import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.bound.BoundaryColouring;
import dct.core.triangulate.Triangulation;
import dct.problem.Solution;
import dct.render.Scene;
import java.util.Objects;

/**
 * What a named step made of the points of a document; immutable.
 *
 * @param view the number of the view that shows it; a later result of the same view takes its place
 * @param title what was done, for a person to read
 * @param solution the triangulation and what is known of it
 * @param scene the picture of the solution
 */
public record Result(int view, String title, Solution solution, Scene scene) {

  /** The view in which sites are drawn: results of theirs are shown there. */
  public static final int CANVAS = 0;

  /** The view of a polygon's result that came with its file. */
  public static final int OPENED = 1;

  /** A result with its picture, made in linear time. */
  public static Result of(int view, String title, Solution solution) {
    return new Result(view, title, solution, Scene.of(solution));
  }

  /**
   * The same triangulation, of vertices with other wishes. Its flips stay; of an optimum for other
   * wishes hardly anything is known.
   */
  public Result wishing(ParityGoal wishes) {
    Solution plain = solution.wishing(wishes);
    Solution same =
        solution
            .flips()
            .map(plain::flipped)
            .orElseGet(
                () ->
                    solution
                        .optimum()
                        .map(best -> plain.optimized(bare(best, wishes), solution.limits()))
                        .orElse(plain));
    return new Result(view, title, same, scene.withoutVerdict());
  }

  private static Optimum bare(Optimum best, ParityGoal wishes) {
    Triangulation made = best.triangulation();
    LowerBound bound =
        wishes.isAll(Wish.EVEN)
            ? BoundaryColouring.allEven(made.boundaryCount(), "boundary vertices")
            : new LowerBound(0, "not searched for with these wishes");
    return new Optimum(made, wishes, wishes.unmet(made), bound, true);
  }

  /** Whether it cannot be made again at once: it has flips or was searched for. */
  public boolean isWorthKeeping() {
    return solution.flips().isPresent() || solution.optimum().isPresent();
  }

  /** The picture follows from the rest. */
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
