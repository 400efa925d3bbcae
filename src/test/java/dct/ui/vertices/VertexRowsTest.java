package dct.ui.vertices;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.problem.Method;
import dct.render.Viewport;
import dct.ui.document.Analysis;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.History;
import dct.ui.tool.ToolContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** The table of the vertices without a window. */
class VertexRowsTest {
  private final Bench bench = new Bench(new Document(Domain.SITES, square()));
  private final VertexRows rows = new VertexRows(bench);
  private final List<String> heard = new ArrayList<>();

  private static Points square() {
    return Points.ofPairs(0, 0, 10, 0, 10.5, 10, -0.25, 10, 4, 5);
  }

  /** A document with its history, and what was said. */
  private static final class Bench implements ToolContext {
    private final History history;
    private String said = "";

    Bench(Document document) {
      history = new History(document);
    }

    @Override
    public Document document() {
      return history.present();
    }

    @Override
    public Analysis shown() {
      return Analysis.of(document(), false, Progress.NONE);
    }

    @Override
    public Viewport viewport() {
      return Viewport.IDENTITY;
    }

    @Override
    public void perform(Edit edit) {
      history.perform(edit);
    }

    @Override
    public void preview(Points points) {
      throw new UnsupportedOperationException();
    }

    @Override
    public void endPreview() {
      throw new UnsupportedOperationException();
    }

    @Override
    public void chooseEdit() {
      throw new UnsupportedOperationException();
    }

    @Override
    public void say(String message) {
      said = message;
    }
  }

  private void show() {
    rows.show(
        bench.document(), Optional.of(bench.shown().solution().orElseThrow().triangulation()));
  }

  private String row(int v) {
    List<String> cells = new ArrayList<>();
    for (int column = 0; column < rows.getColumnCount(); column++) {
      cells.add(String.valueOf(rows.getValueAt(v, column)));
    }
    return String.join(" ", cells);
  }

  @Test
  void aRowHasNumberCoordinatesDegreeAndWish() {
    show();
    assertThat(rows.getRowCount()).isEqualTo(5);
    assertThat(row(3)).isEqualTo("v3 -0.25 10 3 EVEN");
    assertThat(row(4)).isEqualTo("v4 4 5 4 EVEN");
    rows.show(bench.document(), Optional.empty());
    assertThat(row(4)).isEqualTo("v4 4 5 – EVEN");
  }

  @Test
  void degreesOfOtherVerticesAreNotShown() {
    Document three = new Document(Domain.SITES, Points.ofPairs(0, 0, 1, 0, 0, 1));
    Triangulation made = Method.DELAUNAY.run(three.instance("", Progress.NONE), Progress.NONE);
    rows.show(bench.document(), Optional.of(made));
    assertThat(rows.getValueAt(0, VertexRows.DEGREE)).isEqualTo("–");
  }

  @Test
  void whatIsTypedMovesTheVertexByANamedEdit() {
    show();
    rows.setValueAt(" 1e1 ", 4, VertexRows.X);
    assertThat(bench.history.undoLabel()).contains("Edit Vertex v4");
    assertThat(bench.document().points().x(4)).isEqualTo(10);
    assertThat(bench.document().points().y(4)).isEqualTo(5);
    show();
    rows.setValueAt("-7", 4, VertexRows.Y);
    assertThat(row(4)).isEqualTo("v4 10 5 4 EVEN"); // until the document is shown
    show();
    assertThat(rows.getValueAt(4, VertexRows.Y)).isEqualTo("-7");
    bench.history.undo();
    bench.history.undo();
    assertThat(bench.document().points()).isEqualTo(square());
  }

  @Test
  void whatChangesNothingIsNoEdit() {
    show();
    rows.setValueAt("4.0", 4, VertexRows.X);
    rows.setValueAt("-0", 0, VertexRows.X);
    rows.setValueAt(Wish.EVEN, 4, VertexRows.WISH);
    assertThat(bench.history.undoLabel()).isEmpty();
  }

  @Test
  void badInputIsOneSentenceAndChangesNothing() {
    show();
    for (String typed : List.of("", "x", "1,5", "1e999", "NaN", "0x10", "1 2")) {
      bench.said = "";
      rows.setValueAt(typed, 4, VertexRows.X);
      assertThat(bench.said)
          .isEqualTo("“" + typed + "” is no coordinate; type a number such as 12.5");
    }
    rows.setValueAt("10", 0, VertexRows.X);
    assertThat(bench.said).isEqualTo("v1 is already there; type another place for v0");
    assertThat(bench.history.undoLabel()).isEmpty();
    assertThat(bench.document().points()).isEqualTo(square());
  }

  @Test
  void aWishOfManyVerticesIsOneEdit() {
    show();
    rows.wish(Wish.ODD, 1);
    assertThat(bench.history.undoLabel()).contains("Wish Parity v1");
    rows.wish(Wish.ODD, 0, 1, 2);
    assertThat(bench.history.undoLabel()).contains("Wish Parity of 2 Vertices");
    assertThat(bench.document().wishes().count(Wish.ODD)).isEqualTo(3);
    bench.history.undo();
    assertThat(bench.document().wishes().count(Wish.ODD)).isEqualTo(1);
  }

  @Test
  void rowsAreCopiedAsTheyWereThen() {
    rows.wish(Wish.ANY, 3);
    show();
    var copied = rows.copy(0, 3);
    rows.setValueAt("99", 0, VertexRows.X);
    show();
    assertThat(copied.get()).isEqualTo("0\t0\t0\t3\teven\n3\t-0.25\t10\t3\tany\n");
  }

  @Test
  void onlyTheNumberOfRowsThatDifferIsTold() {
    show();
    rows.addTableModelListener(
        e -> heard.add(e.getType() + ":" + e.getFirstRow() + "-" + e.getLastRow()));
    show();
    bench.perform(Edit.draw(bench.document(), 3, 3));
    show();
    bench.history.undo();
    show();
    assertThat(heard).containsExactly("0:0-4", "1:5-5", "0:0-5", "-1:5-5", "0:0-4");
  }
}
