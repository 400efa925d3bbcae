package dct.ui.tool;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import java.awt.event.KeyEvent;
import org.junit.jupiter.api.Test;

/** How a drawing grows and ends. */
class DrawToolTest {
  private final FakeContext polygon =
      new FakeContext(Domain.POLYGON, 100, 100, 300, 100, 300, 300, 100, 300);
  private final FakeContext sites = new FakeContext(Domain.SITES, 100, 100, 300, 100, 200, 300);
  private final DrawTool tool = new DrawTool();

  private static Key key(int code) {
    return new Key(code, false);
  }

  @Test
  void aClickOnTheFirstVertexEndsAPolygon() {
    tool.pressed(polygon, polygon.spot(103, 98));
    assertThat(polygon.points().size()).isEqualTo(4);
    assertThat(polygon.editing).isTrue();
  }

  @Test
  void aClickThatSnapsToTheFirstVertexEndsAPolygon() {
    polygon.snap.toggle(Snap.To.GRID); // of 20
    tool.moved(polygon, polygon.spot(91, 109));
    assertThat(tool.hint(polygon)).isEqualTo("Click v0 to end the drawing");
    tool.pressed(polygon, polygon.spot(91, 109));
    assertThat(polygon.points().size()).isEqualTo(4);
    assertThat(polygon.editing).isTrue();
  }

  @Test
  void aClickOnTheFirstOfTwoVerticesDoesNotEnd() {
    FakeContext two = new FakeContext(Domain.POLYGON, 100, 100, 300, 100);
    tool.pressed(two, two.spot(100, 100));
    assertThat(two.said).contains("v0 is already there");
    assertThat(two.editing).isFalse();
  }

  @Test
  void aDoubleClickAddsOneVertexAndEndsAPolygon() {
    tool.pressed(polygon, polygon.spot(50, 200));
    tool.pressed(polygon, polygon.spot(51, 199).clicked(2));
    assertThat(polygon.points().size()).isEqualTo(5);
    assertThat(polygon.editing).isTrue();
  }

  @Test
  void aDoubleClickIsOneSite() {
    tool.pressed(sites, sites.spot(50, 200));
    tool.pressed(sites, sites.spot(51, 199).clicked(2));
    tool.pressed(sites, sites.spot(51, 199).clicked(3));
    assertThat(sites.points()).isEqualTo(Points.ofPairs(100, 100, 300, 100, 200, 300, 50, 200));
    assertThat(sites.editing).isFalse();
  }

  @Test
  void aDoubleClickDoesNotEndWhatIsNoPolygonYet() {
    FakeContext none = new FakeContext(Domain.POLYGON);
    tool.pressed(none, none.spot(50, 200));
    tool.pressed(none, none.spot(50, 200).clicked(2));
    assertThat(none.points().size()).isEqualTo(1);
    assertThat(none.editing).isFalse();
  }

  @Test
  void enterEnds() {
    assertThat(tool.keyPressed(polygon, key(KeyEvent.VK_ENTER))).isTrue();
    assertThat(polygon.editing).isTrue();
    assertThat(tool.keyPressed(sites, key(KeyEvent.VK_ENTER))).isTrue();
    assertThat(sites.editing).isTrue();
  }

  @Test
  void enterDoesNotEndWhatIsNoPolygonYetButEscapeLeavesIt() {
    FakeContext two = new FakeContext(Domain.POLYGON, 100, 100, 300, 100);
    tool.keyPressed(two, key(KeyEvent.VK_ENTER));
    assertThat(two.editing).isFalse();
    assertThat(two.said).contains("three vertices");
    tool.keyPressed(two, key(KeyEvent.VK_ESCAPE));
    assertThat(two.editing).isTrue();
    assertThat(two.points().size()).isEqualTo(2);
  }

  @Test
  void backspaceTakesTheLastVertexBackUntilThereIsNone() {
    FakeContext two = new FakeContext(Domain.POLYGON, 100, 100, 300, 100);
    tool.keyPressed(two, key(KeyEvent.VK_BACK_SPACE));
    assertThat(two.points()).isEqualTo(Points.ofPairs(100, 100));
    assertThat(two.history.undoLabel()).contains("Delete Vertex v1");
    tool.keyPressed(two, key(KeyEvent.VK_BACK_SPACE));
    tool.keyPressed(two, key(KeyEvent.VK_BACK_SPACE));
    assertThat(two.points().size()).isZero();
    assertThat(two.said).contains("no vertex to take back");
  }

  @Test
  void otherKeysAreOfNoUse() {
    assertThat(tool.keyPressed(polygon, key(KeyEvent.VK_K))).isFalse();
  }

  @Test
  void hintsSayHowToGoOnAndHowToEnd() {
    assertThat(tool.hint(polygon)).contains("add v4").contains("Enter");
    tool.moved(polygon, polygon.spot(101, 99));
    assertThat(tool.hint(polygon)).isEqualTo("Click v0 to end the drawing");
    assertThat(tool.hint(sites)).contains("site v3").contains("Enter");
  }
}
