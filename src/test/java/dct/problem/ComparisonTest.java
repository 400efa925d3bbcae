package dct.problem;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.degree.FlipResult;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.RandomSites;
import dct.testing.HandFlips;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ComparisonTest {
  private static Triangulation delaunay(Points points) {
    return Delaunay.triangulate(Sites.of(points, Progress.NONE), Progress.NONE);
  }

  private static String edge(Triangulation triangulation, int edge) {
    int u = triangulation.from(edge);
    int v = triangulation.to(edge);
    return Math.min(u, v) + " " + Math.max(u, v);
  }

  private static Set<String> edges(Triangulation triangulation) {
    return IntStream.range(0, triangulation.edgeCount())
        .mapToObj(edge -> edge(triangulation, edge))
        .collect(Collectors.toSet());
  }

  private static Set<String> named(Triangulation triangulation, List<Integer> edges) {
    return edges.stream().map(edge -> edge(triangulation, edge)).collect(Collectors.toSet());
  }

  @Test
  void one_flip_is_one_edge_here_and_one_there() {
    Triangulation square = delaunay(Points.ofPairs(0, 0, 4, 0, 4, 4, 0, 3));
    int diagonal = square.edgeBetween(1, 3).orElseThrow();
    Triangulation flipped = FlipResult.of(square, diagonal).after();
    Comparison comparison = Comparison.of(square, flipped);
    assertThat(comparison.onlyFirst()).containsExactly(diagonal);
    assertThat(comparison.onlySecond()).containsExactly(diagonal);
    assertThat(comparison.common()).isEqualTo(4);
    assertThat(comparison.parities()).containsExactly(0, 1, 2, 3);
    assertThat(comparison.isSame()).isFalse();
    assertThat(Comparison.of(square, square).isSame()).isTrue();
  }

  @Test
  void the_edges_are_those_of_the_two_sets() {
    for (long seed = 0; seed < 20; seed++) {
      Triangulation first = delaunay(RandomSites.uniform(60, seed));
      Triangulation second = HandFlips.of(first, 40).after();
      Comparison comparison = Comparison.of(first, second);
      Set<String> gone = edges(first);
      gone.removeAll(edges(second));
      Set<String> come = edges(second);
      come.removeAll(edges(first));
      assertThat(named(first, comparison.onlyFirst())).isEqualTo(gone).isNotEmpty();
      assertThat(named(second, comparison.onlySecond())).isEqualTo(come);
      assertThat(comparison.onlyFirst()).hasSize(gone.size()).hasSameSizeAs(come);
      assertThat(comparison.common()).isEqualTo(first.edgeCount() - gone.size());
      assertThat(comparison.parities())
          .allMatch(v -> first.isEven(v) != second.isEven(v))
          .hasSize(
              (int)
                  IntStream.range(0, 60).filter(v -> first.isEven(v) != second.isEven(v)).count());
    }
  }

  @Test
  void different_points_are_not_compared() {
    Triangulation one = delaunay(RandomSites.uniform(10, 1));
    Triangulation other = delaunay(RandomSites.uniform(10, 2));
    assertThatThrownBy(() -> Comparison.of(one, other))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
