package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.problem.Method;
import dct.problem.Solution;
import dct.ui.document.Analysis;
import dct.ui.document.Document;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** With live triangulation on, counts and edges follow the mouse while it drags a vertex. */
class LiveWindowTest extends WindowTest {
  private static final double[] HEPTAGON = {
    100, 100, 300, 140, 500, 100, 520, 300, 400, 450, 200, 450, 80, 300
  };

  /** Where v6 is dragged: across the polygon, so that v1 and v3 no longer see each other. */
  private static final double[][] PATH = {{150, 300}, {300, 280}, {470, 250}};

  @Test
  void theProvenOptimumFollowsAVertexThatIsDragged() {
    choose("Polygon Based");
    clickAt(HEPTAGON);
    check("Edit Vertex");
    type(KeyEvent.VK_L);
    Solution before = shown().solution().orElseThrow();
    requireOptimum(before, Points.ofPairs(HEPTAGON));
    press(80, 300);
    for (double[] place : PATH) {
      moveTo(place[0], place[1]);
      Points moved =
          onEventThread(() -> window.workbench().active().orElseThrow().visible().points());
      assertThat(moved.x(6)).isCloseTo(place[0], org.assertj.core.data.Offset.offset(2.0));
      assertThat(points()).as("no step before the release").isEqualTo(Points.ofPairs(HEPTAGON));
      Analysis now = shown();
      assertThat(now.document().points()).isEqualTo(moved);
      requireOptimum(now.solution().orElseThrow(), moved);
      assertThat(counts()).isEqualTo(onEventThread(() -> now.scene().counts()));
    }
    Solution dragged = shown().solution().orElseThrow();
    assertThat(edges(dragged)).isNotEqualTo(edges(before));
    release();
    assertThat(edges(shown().solution().orElseThrow())).isEqualTo(edges(dragged));
    assertThat(points()).isEqualTo(shown().document().points());
  }

  private Analysis shown() {
    return onEventThread(() -> window.workbench().shown());
  }

  /** What the canvas writes above the picture. */
  private List<String> counts() {
    return onEventThread(() -> canvas().scene().counts());
  }

  private static void requireOptimum(Solution shown, Points polygon) {
    Solution alone =
        Solution.of(
                new Document(Domain.POLYGON, polygon)
                    .instance("", Progress.NONE)
                    .with(ParityGoal.allEven(polygon.size())),
                Method.MONOTONE,
                Progress.NONE)
            .optimized(SearchLimits.DEFAULT, Progress.NONE);
    assertThat(shown.isProven()).isTrue();
    assertThat(shown.unmet()).isEqualTo(alone.unmet());
  }

  private static Set<List<Integer>> edges(Solution solution) {
    Set<List<Integer>> edges =
        new TreeSet<>(java.util.Comparator.comparing(List<Integer>::toString));
    for (int edge = 0; edge < solution.triangulation().edgeCount(); edge++) {
      int from = solution.triangulation().from(edge);
      int to = solution.triangulation().to(edge);
      edges.add(List.of(Math.min(from, to), Math.max(from, to)));
    }
    return edges;
  }
}
