package dct.ui.document;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import org.junit.jupiter.api.Test;

/** A result is called by what was done last. */
class ResultTitleTest {
  private static final Solution CONVEX =
      Solution.of(
          Instance.of(
              Domain.POLYGON,
              "convex",
              Points.ofPairs(0, 0, 5, -2, 9, 1, 10, 6, 4, 9, -1, 5),
              Progress.NONE),
          Method.CONVEX_EVEN,
          Progress.NONE);

  private static Solution best(ParityGoal goal) {
    return CONVEX.wishing(goal).optimized(SearchLimits.DEFAULT, Progress.NONE);
  }

  @Test
  void a_method_gives_its_title() {
    assertThat(ResultTitle.of(CONVEX)).isEqualTo("Convex Polygon Even Triangulation");
  }

  @Test
  void an_optimum_is_called_by_its_goal_and_not_by_what_it_began_with() {
    assertThat(ResultTitle.of(best(ParityGoal.allEven(6)))).isEqualTo("Most Even Vertices");
    assertThat(ResultTitle.of(best(ParityGoal.allOdd(6)))).isEqualTo("Most Odd Vertices");
    assertThat(ResultTitle.of(best(ParityGoal.allEven(6).with(2, Wish.ODD))))
        .isEqualTo("Wished Parities");
  }

  @Test
  void flips_say_after_what_they_came_however_many_there_were() {
    Solution flipped = best(ParityGoal.allEven(6)).flipped(Progress.NONE);
    assertThat(ResultTitle.of(flipped)).isEqualTo("Perform Flip after Most Even Vertices");
    assertThat(ResultTitle.of(flipped.flipped(Progress.NONE)))
        .isEqualTo("Perform Flip after Most Even Vertices");
  }
}
