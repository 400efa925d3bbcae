package dct.ui.document;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Defect;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.triangulate.Domain;
import dct.problem.Instance;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class LayoutTest {
  private static final Points SQUARE = Points.ofPairs(0, 0, 100, 0, 100, 100, 0, 100);

  private Document document = new Document(Domain.POLYGON, SQUARE);

  private void perform(Edit edit) {
    document = edit.apply(document);
  }

  private void beginHole() {
    perform(Edit.layout("New Hole", document, document.layout().withHole(document.size())));
  }

  private void draw(double... places) {
    for (int k = 0; k < places.length; k += 2) {
      perform(Edit.draw(document, places[k], places[k + 1]));
    }
  }

  private int[] ring(int r) {
    return document.rings().ring(r);
  }

  @Test
  void aHoleIsDrawnVertexByVertex() {
    beginHole();
    assertThat(document.content()).isEqualTo(Domain.POLYGON);
    draw(40, 40, 60, 40);
    assertThat(Analysis.of(document, true, Progress.NONE).defects()).isEmpty();
    assertThat(Analysis.of(document, false, Progress.NONE).defects())
        .extracting(Defect::kind)
        .containsExactly(Defect.Kind.SMALL_HOLE);
    draw(50, 60);
    assertThat(document.content()).isEqualTo(Domain.REGION);
    assertThat(ring(1)).containsExactly(4, 5, 6);
    Instance instance = document.instance("", Progress.NONE);
    assertThat(instance.description()).contains("7 vertices, 1 hole, 0 sites");
    assertThat(document.isOf(instance)).isTrue();
  }

  @Test
  void onlyTheProvisionalEdgeMayCross() {
    beginHole();
    draw(40, 40, 60, 40, 60, 60, 45, 20); // v6–v7 crosses v4–v5
    assertThat(Analysis.of(document, true, Progress.NONE).defects())
        .extracting(Defect::kind)
        .containsOnly(Defect.Kind.CROSSING);
    perform(Edit.delete(document, 7));
    draw(80, 50); // the closing edge v7–v4 crosses v5–v6
    assertThat(Analysis.of(document, true, Progress.NONE).defects()).isEmpty();
    assertThat(Analysis.of(document, false, Progress.NONE).defects()).isNotEmpty();
  }

  @Test
  void numbersStayInTheOrderOfTheFile() {
    beginHole();
    draw(40, 40, 60, 40, 50, 60);
    perform(Edit.site(document, 20, 20));
    perform(Edit.layout("Fix", document, document.layout().toggled(0, 7, 8)));
    perform(Edit.split(document, 0, 1, 50, 0));
    assertThat(ring(0)).containsExactly(0, 1, 2, 3, 4);
    assertThat(ring(1)).containsExactly(5, 6, 7);
    assertThat(document.rings().isFixed(0, 8)).isTrue();
    beginHole();
    draw(80, 80);
    assertThat(document.layout().last(document.size())).isEqualTo(8);
    assertThat(document.rings().isFixed(0, 9)).isTrue();
    perform(Edit.delete(document, 8));
    assertThat(document.rings().count()).isEqualTo(2);
    assertThat(document.layout().isHole()).isTrue(); // vertices are drawn in the first hole again
    perform(Edit.split(document, 0, 8, 10, 10));
    assertThat(document.rings().isFixed(0, 9)).isTrue();
    assertThat(document.rings().isFixed(9, 8)).isTrue();
    assertThat(document.rings().isFixed(0, 8)).isFalse();
  }

  @Test
  void withoutHolesSitesAndFixedEdgesItIsAPolygonAgain() {
    beginHole();
    draw(40, 40, 60, 40, 50, 60);
    perform(Edit.site(document, 20, 20));
    perform(Edit.layout("Fix", document, document.layout().toggled(0, 7, 8)));
    perform(BulkEdit.delete("Delete", document, Selection.of(4, 5, 6, 7)));
    assertThat(document.layout().isPlain()).isTrue();
    assertThat(document).isEqualTo(new Document(Domain.POLYGON, SQUARE));
  }

  @Test
  void pastedVerticesJoinTheRingBehindWhichTheyCome() {
    beginHole();
    draw(40, 40, 60, 40, 50, 60);
    perform(Edit.site(document, 20, 20));
    Points two = Points.ofPairs(60, 0, 80, 0);
    perform(BulkEdit.insert("Paste", document, 1, two, ParityGoal.allEven(2)));
    assertThat(ring(0)).containsExactly(0, 1, 2, 3, 4, 5);
    perform(BulkEdit.insert("Paste", document, 9, two, ParityGoal.allEven(2)));
    assertThat(ring(1)).containsExactly(6, 7, 8, 9, 10);
    perform(BulkEdit.insert("Paste", document, 12, two, ParityGoal.allEven(2)));
    assertThat(document.layout().sites(document.size())).isEqualTo(3);
  }

  @Test
  void aRingIsKeptAsRuns() {
    for (int[] ring : new int[][] {{}, {4}, {0, 1, 2}, {3, 4, 9, 10, 11, 2}, {5, 3, 1}}) {
      RingRuns runs = RingRuns.of(ring);
      assertThat(runs.vertices()).containsExactly(ring);
      assertThat(runs.size()).isEqualTo(ring.length);
      assertThat(runs.first()).isEqualTo(ring.length == 0 ? -1 : ring[0]);
      assertThat(runs.last()).isEqualTo(ring.length == 0 ? -1 : ring[ring.length - 1]);
      assertThat(runs.highest()).isEqualTo(Arrays.stream(ring).max().orElse(-1));
      assertThat(runs).isEqualTo(RingRuns.of(ring.clone()));
    }
    assertThat(RingRuns.ofAll(3)).isEqualTo(RingRuns.of(0, 1, 2));
    assertThat(RingRuns.of(0, 1, 2)).isNotEqualTo(RingRuns.of(0, 1, 3));
  }

  @Test
  void ringsAreTheSameWhicheverWayTheyRun() {
    Points points = Points.ofPairs(0, 0, 100, 0, 100, 100, 0, 100, 40, 40, 60, 40, 50, 60, 9, 9);
    Rings rings = Rings.of(points, List.of(new int[] {0, 1, 2, 3}, new int[] {4, 5, 6}), 0, 7);
    Rings other = Rings.of(points, List.of(new int[] {2, 1, 0, 3}, new int[] {6, 5, 4}), 7, 0);
    assertThat(rings.hasEdgesOf(other)).isTrue();
    for (Rings different :
        List.of(
            Rings.of(points, List.of(new int[] {0, 2, 1, 3}, new int[] {4, 5, 6}), 0, 7),
            Rings.of(points, List.of(new int[] {0, 1, 2, 3}, new int[] {4, 5, 6})),
            Rings.of(points, List.of(new int[] {0, 1, 2, 3}, new int[] {4, 5, 6, 7})),
            Rings.of(points, List.of(new int[] {0, 1, 2, 3}, new int[] {4, 5, 7}), 0, 7),
            Rings.of(points, List.of(new int[] {0, 1, 2, 3}), 0, 7))) {
      assertThat(rings.hasEdgesOf(different)).isFalse();
    }
  }
}
