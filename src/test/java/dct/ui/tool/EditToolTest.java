package dct.ui.tool;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.render.Viewport;
import dct.ui.document.Selection;
import java.awt.event.KeyEvent;
import org.junit.jupiter.api.Test;

/** Selecting, and moving what is selected. */
class EditToolTest {
  private final FakeContext polygon =
      new FakeContext(Domain.POLYGON, 100, 100, 300, 100, 300, 300, 100, 300);
  private final FakeContext sites = new FakeContext(Domain.SITES, 100, 100, 300, 100, 200, 300);
  private final EditTool tool = new EditTool();

  private void click(double x, double y, boolean shift) {
    drag(x, y, x, y, shift);
  }

  private void drag(double x, double y, double toX, double toY, boolean shift) {
    tool.pressed(polygon, polygon.spot(x, y).withShift(shift));
    tool.dragged(polygon, polygon.spot(toX, toY).withShift(shift));
    tool.released(polygon, polygon.spot(toX, toY).withShift(shift));
  }

  @Test
  void aClickSelectsAndWithShiftOneMoreOrOneLess() {
    click(100, 100, false);
    assertThat(polygon.selection).isEqualTo(Selection.of(0));
    click(300, 300, true);
    assertThat(polygon.selection).isEqualTo(Selection.of(0, 2));
    click(100, 100, true);
    assertThat(polygon.selection).isEqualTo(Selection.of(2));
    click(300, 100, false);
    assertThat(polygon.selection).isEqualTo(Selection.of(1));
    click(200, 200, true);
    assertThat(polygon.selection).isEqualTo(Selection.of(1));
    click(200, 200, false);
    assertThat(polygon.selection).isEqualTo(Selection.NONE);
    assertThat(polygon.history.undoLabel()).isEmpty();
  }

  @Test
  void aTremblingClickMovesNothing() {
    drag(300, 100, 302, 101, false);
    assertThat(polygon.history.undoLabel()).isEmpty();
    assertThat(polygon.selection).isEqualTo(Selection.of(1));
  }

  @Test
  void aDragOverEmptyGroundSelectsWhatIsInside() {
    drag(50, 50, 350, 150, false);
    assertThat(polygon.selection).isEqualTo(Selection.of(0, 1));
    drag(350, 350, 250, 250, true);
    assertThat(polygon.selection).isEqualTo(Selection.of(0, 1, 2));
    drag(350, 350, 250, 250, false);
    assertThat(polygon.selection).isEqualTo(Selection.of(2));
  }

  @Test
  void aDragOfASelectedVertexMovesAllThatAre() {
    polygon.selection = Selection.of(0, 2);
    drag(100, 100, 110, 130, false);
    assertThat(polygon.points()).isEqualTo(Points.ofPairs(110, 130, 300, 100, 310, 330, 100, 300));
    assertThat(polygon.history.undoLabel()).contains("Move 2 Vertices");
    assertThat(polygon.selection).isEqualTo(Selection.of(0, 2));
    polygon.history.undo();
    assertThat(polygon.history.undoLabel()).isEmpty();
  }

  @Test
  void aDragOfAnotherVertexMovesThatAlone() {
    polygon.selection = Selection.of(0, 2);
    drag(300, 100, 310, 130, false);
    assertThat(polygon.points()).isEqualTo(Points.ofPairs(100, 100, 310, 130, 300, 300, 100, 300));
    assertThat(polygon.history.undoLabel()).contains("Edit Vertex v1");
    assertThat(polygon.selection).isEqualTo(Selection.of(1));
  }

  @Test
  void withShiftADragKeepsOneCoordinate() {
    tool.pressed(polygon, polygon.spot(300, 100));
    tool.dragged(polygon, polygon.spot(350, 120).withShift(true));
    tool.released(polygon, polygon.spot(350, 120).withShift(true));
    assertThat(polygon.points().x(1)).isEqualTo(350);
    assertThat(polygon.points().y(1)).isEqualTo(100);
  }

  @Test
  void aDragSnapsAndTheOthersFollow() {
    polygon.snap.toggle(Snap.To.GRID);
    polygon.selection = Selection.of(0, 2);
    drag(100, 100, 117, 93, false);
    assertThat(polygon.points()).isEqualTo(Points.ofPairs(120, 100, 300, 100, 320, 300, 100, 300));
  }

  @Test
  void selectedSitesAreNotDroppedOnOthers() {
    sites.selection = Selection.of(0, 2);
    tool.pressed(sites, sites.spot(100, 100));
    tool.dragged(sites, sites.spot(300, 100));
    tool.released(sites, sites.spot(300, 100));
    assertThat(sites.history.undoLabel()).isEmpty();
    assertThat(sites.preview).isNull();
    assertThat(sites.said).contains("already there");
  }

  @Test
  void arrowsMoveTheSelectionInOneEdit() {
    polygon.selection = Selection.of(1, 3);
    assertThat(tool.keyPressed(polygon, new Key(KeyEvent.VK_RIGHT, false))).isTrue();
    tool.keyPressed(polygon, new Key(KeyEvent.VK_RIGHT, false));
    tool.keyPressed(polygon, new Key(KeyEvent.VK_DOWN, true));
    assertThat(polygon.preview.x(1)).isEqualTo(302);
    assertThat(polygon.history.undoLabel()).isEmpty();
    tool.keysReleased(polygon);
    assertThat(polygon.points()).isEqualTo(Points.ofPairs(100, 100, 302, 110, 300, 300, 102, 310));
    assertThat(polygon.history.undoLabel()).contains("Move 2 Vertices");
    tool.keysReleased(polygon);
    polygon.history.undo();
    assertThat(polygon.history.undoLabel()).isEmpty();
  }

  @Test
  void anUndoWhileAnArrowIsHeldEndsTheMove() {
    polygon.selection = Selection.of(1);
    tool.keyPressed(polygon, new Key(KeyEvent.VK_RIGHT, false));
    tool.keysReleased(polygon);
    tool.keyPressed(polygon, new Key(KeyEvent.VK_RIGHT, false));
    polygon.history.undo();
    tool.keysReleased(polygon);
    assertThat(polygon.points().x(1)).isEqualTo(300);
  }

  @Test
  void arrowsThatMoveNothingAreLeftToTheCross() {
    assertThat(tool.keyPressed(polygon, new Key(KeyEvent.VK_RIGHT, false))).isFalse();
  }

  @Test
  void anArrowMovesByAUnitAtTheScaleOfThePicture() {
    assertThat(Spot.step(Viewport.IDENTITY)).isEqualTo(1);
    assertThat(Spot.step(Viewport.IDENTITY.zoomed(5, 0, 0))).isEqualTo(1);
    assertThat(Spot.step(Viewport.IDENTITY.zoomed(0.3, 0, 0))).isEqualTo(1);
    assertThat(Spot.step(Viewport.IDENTITY.zoomed(700, 0, 0))).isEqualTo(0.01);
    assertThat(Spot.step(Viewport.IDENTITY.zoomed(0.002, 0, 0))).isEqualTo(100);
    assertThat(Spot.stepped(Viewport.IDENTITY.zoomed(70, 0, 0), 0.2, 0.1)).isEqualTo(0.3);
  }

  @Test
  void escapeLetsGo() {
    polygon.selection = Selection.of(1, 3);
    assertThat(tool.keyPressed(polygon, Key.ESCAPE)).isTrue();
    assertThat(polygon.selection).isEqualTo(Selection.NONE);
    assertThat(tool.keyPressed(polygon, Key.ESCAPE)).isFalse();
  }

  @Test
  void hintsSayWhatIsSelected() {
    polygon.selection = Selection.of(1, 3);
    assertThat(tool.hint(polygon)).startsWith("2 vertices selected");
    tool.moved(polygon, polygon.spot(300, 100));
    assertThat(tool.hint(polygon)).isEqualTo("Drag to move all that are selected");
  }
}
