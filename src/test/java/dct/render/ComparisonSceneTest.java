package dct.render;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.problem.Comparison;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The picture of what differs between two triangulations. */
class ComparisonSceneTest {
  private static final Points HEXAGON =
      Points.ofPairs(0, 0, 100, -40, 200, 0, 210, 120, 100, 170, -5, 110);

  private static Solution solution(Method method) {
    Instance instance = Instance.of(Domain.POLYGON, "hexagon", HEXAGON, Progress.NONE);
    return Solution.of(instance, method, Progress.NONE);
  }

  @Test
  void everyEdgeIsDrawnOnceAndEachResultHasALookOfItsOwn() {
    Comparison comparison =
        Comparison.of(
            solution(Method.MONOTONE).triangulation(),
            solution(Method.CONVEX_EVEN).triangulation());
    assertThat(comparison.isSame()).isFalse();
    Scene scene = ComparisonScene.of(comparison, "one", "other");
    List<IndexedEdges> layers = scene.index().layers();
    assertThat(edges(layers, Ink.FIRST, false)).isEqualTo(comparison.onlyFirst().size());
    assertThat(edges(layers, Ink.SECOND, true)).isEqualTo(comparison.onlySecond().size());
    assertThat(scene.edgeCount())
        .isEqualTo(comparison.common() + 2 * comparison.onlyFirst().size());
    assertThat(scene.unmet()).hasSize(comparison.parities().size());
    assertThat(String.join("\n", scene.counts()))
        .contains("one", "other", Integer.toString(comparison.common()));
  }

  @Test
  void theLegendNamesTheEdgesOfEachAndWhatRingsMean() {
    Comparison comparison =
        Comparison.of(
            solution(Method.MONOTONE).triangulation(),
            solution(Method.CONVEX_EVEN).triangulation());
    RecordingPen pen = new RecordingPen();
    Legend legend = new Legend(ComparisonScene.of(comparison, "one", "other"));
    legend.write(pen, new Box(0, 0, 300, 200), false);
    assertThat(pen.texts())
        .contains("Only in A", "Only in B", "In both", "Parity differs")
        .doesNotContain("Unmet wish");
  }

  @Test
  void equalTriangulationsHaveNothingOfTheirOwn() {
    Solution solution = solution(Method.MONOTONE);
    Comparison same = Comparison.of(solution.triangulation(), solution.triangulation());
    Scene scene = ComparisonScene.of(same, "one", "other");
    assertThat(edges(scene.index().layers(), Ink.FIRST, false)).isZero();
    assertThat(edges(scene.index().layers(), Ink.SECOND, true)).isZero();
    assertThat(scene.unmet()).isEmpty();
  }

  private static int edges(List<IndexedEdges> layers, Ink ink, boolean dashed) {
    return layers.stream()
        .filter(layer -> layer.stroke().ink() == ink && layer.stroke().dashed() == dashed)
        .mapToInt(
            layer ->
                layer.blocks().count() == 0 ? 0 : layer.blocks().end(layer.blocks().count() - 1))
        .sum();
  }
}
