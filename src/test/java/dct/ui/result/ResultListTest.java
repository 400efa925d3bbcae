package dct.ui.result;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.problem.Solution;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.document.Result;
import dct.ui.job.Jobs;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Which results there are of the present points, and what a table says of them. */
class ResultListTest {
  private static final Points SITES =
      Points.ofPairs(0, 0, 100, 5, 210, 0, 190, 110, 120, 90, 60, 160, 10, 90, 80, 40);

  private final Editor editor = new Editor(Domain.SITES, new Jobs());
  private final ResultList list = new ResultList();

  ResultListTest() {
    editor.load(new Document(Domain.SITES, SITES), "sites");
  }

  private Result flip() {
    Solution flipped = editor.shown().solution().orElseThrow().flipped(Progress.NONE);
    Result result =
        Result.of(Result.CANVAS, "Perform Flip", flipped).taking(Duration.ofMillis(1500));
    editor.perform(Edit.result("Perform Flip", editor.document(), Optional.of(result)));
    return result;
  }

  @Test
  void sitesBeginWithDelaunayAndUndoTakesTheFlipsAway() {
    assertThat(list.of(editor)).extracting(Result::title).containsExactly("Delaunay Triangulation");
    Result flipped = flip();
    assertThat(list.of(editor)).hasSize(2).endsWith(flipped);
    editor.undo();
    assertThat(list.of(editor)).hasSize(1);
  }

  @Test
  void theSameDelaunayTriangulationIsTheSameResult() {
    assertThat(list.of(editor).get(0)).isSameAs(list.of(editor).get(0));
  }

  @Test
  void resultsOfEarlierPointsAreLeftOut() {
    flip();
    editor.perform(Edit.move(editor.document(), 3, 195, 111));
    assertThat(list.of(editor)).extracting(Result::title).containsExactly("Delaunay Triangulation");
    editor.undo();
    assertThat(list.of(editor)).hasSize(2);
  }

  @Test
  void rowsAreCopiedAsTextWithTabs() {
    Result flipped = flip();
    ResultRows rows = new ResultRows();
    rows.show(list.of(editor));
    String[] lines = rows.lines(1).lines().toArray(String[]::new);
    assertThat(lines).hasSize(2);
    List<String> heads = List.of(lines[0].split("\t", -1));
    List<String> cells = List.of(lines[1].split("\t", -1));
    assertThat(cells).hasSameSizeAs(heads);
    assertThat(cells.get(heads.indexOf("Time (s)"))).isEqualTo("1.5000");
    assertThat(cells.get(heads.indexOf("Odd")))
        .isEqualTo(Integer.toString(flipped.solution().counts().odd()));
    assertThat(cells.get(heads.indexOf("Flips")))
        .isEqualTo(Integer.toString(flipped.solution().flips().orElseThrow().flips()));
  }
}
