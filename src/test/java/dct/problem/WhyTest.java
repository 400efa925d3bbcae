package dct.problem;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.degree.Explanation;
import dct.core.degree.Flip;
import dct.core.degree.Mark;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.RandomSites;
import dct.testing.CancelledAfter;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;

class WhyTest {

  private static Solution solution(Domain domain, Points points) {
    Instance instance = Instance.of(domain, "x", points, Progress.NONE);
    return Solution.of(instance, Method.byDefault(domain), Progress.NONE);
  }

  private static Solution best(Solution solution) {
    return solution.optimized(SearchLimits.DEFAULT, Progress.NONE);
  }

  private static Explanation why(Solution solution) {
    return Why.of(solution, Progress.NONE);
  }

  private static Points lattice(int columns, int rows) {
    double[] pairs = new double[2 * columns * rows];
    for (int k = 0; k < columns * rows; k++) {
      pairs[2 * k] = k % columns;
      pairs[2 * k + 1] = Math.floorDiv(k, columns);
    }
    return Points.ofPairs(pairs);
  }

  @Test
  void a_proven_optimum_says_so_and_why() {
    Explanation why = why(best(solution(Domain.SITES, lattice(5, 6))));
    assertThat(why.title()).isEqualTo("The sites are all points of a lattice in their hull");
    assertThat(why.sentences().get(0))
        .isEqualTo(
            "There are 2 odd vertices, and it is proven that no triangulation has fewer. Why?");
    assertThat(why.text()).containsPattern("have (8|10|0), (8|10|0) and (8|10|0)\\.");
  }

  @Test
  void without_an_odd_vertex_nothing_can_be_better() {
    Solution best =
        best(solution(Domain.POLYGON, Points.ofPairs(0, 0, 5, -2, 9, 1, 10, 6, 4, 9, -1, 5)));
    assertThat(why(best).sentences().get(0))
        .isEqualTo("There are no odd vertices, and nothing can be better than that.");
  }

  @Test
  void an_open_gap_is_named_with_what_would_close_it() {
    Solution delaunay = solution(Domain.SITES, RandomSites.uniform(50, 5));
    int odd = delaunay.counts().odd();
    int bound = delaunay.bound().value();
    Explanation why = why(delaunay);
    assertThat(why.sentences().get(0))
        .startsWith(
            "There are " + odd + " odd vertices. It is proven that every triangulation has ")
        .endsWith("fewer than " + odd + ".");
    assertThat(why.sentences().get(1)).contains("would have to rise by " + (odd - bound));
  }

  @Test
  void the_table_of_a_polygon_is_told_with_its_size() {
    Points points = PolygonShape.of("two-opt").orElseThrow().generate(30, 3).points();
    Instance odd =
        Instance.of(Domain.POLYGON, "x", points, Progress.NONE).with(ParityGoal.allOdd(30));
    Solution best = best(Solution.of(odd, Method.MONOTONE, Progress.NONE));
    assertThat(best.unmet()).isGreaterThan(2);
    Explanation why = why(best);
    assertThat(why.title()).isEqualTo("Every triangulation was counted");
    assertThat(why.text()).containsPattern("\\d+ pairs of the 30 vertices see each other");
    assertThat(why.marks()).hasSize(best.unmet()).allMatch(m -> m.tone() == Mark.Tone.FAULT);
  }

  @Test
  void sites_on_their_hull_are_a_polygon() {
    double[] pairs = new double[40];
    for (int i = 0; i < 20; i++) {
      pairs[2 * i] = i;
      pairs[2 * i + 1] = i * i;
    }
    Solution plain = solution(Domain.SITES, Points.ofPairs(pairs));
    Solution odd =
        best(
            Solution.of(
                plain.instance().with(ParityGoal.allOdd(20)), Method.DELAUNAY, Progress.NONE));
    assertThat(odd.unmet()).isPositive();
    assertThat(why(odd).text()).contains("wish");
  }

  @Test
  void a_result_flipped_by_hand_is_explained_by_the_same_bound() {
    Solution best = best(solution(Domain.SITES, lattice(5, 6)));
    int edge = 0;
    while (Flip.at(best.triangulation(), edge).stream()
        .noneMatch(flip -> flip.evenGain(best.triangulation()) < 0)) {
      edge++;
    }
    Explanation why = why(best.flippedAt(edge));
    assertThat(why.title()).isEqualTo(why(best).title());
    assertThat(why.marks()).hasSameSizeAs(why(best).marks());
    assertThat(why.sentences().get(0)).contains("every triangulation has 2 or more");
  }

  @Test
  void it_can_be_cancelled() {
    Solution best = best(solution(Domain.SITES, lattice(5, 6)));
    assertThatThrownBy(() -> Why.of(best, new CancelledAfter(1)))
        .isInstanceOf(CancellationException.class);
  }
}
