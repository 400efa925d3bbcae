package dct.ui.tool;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.render.Viewport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ToolsTest {
  private final FakeContext polygon =
      new FakeContext(Domain.POLYGON, 100, 100, 300, 100, 300, 300, 100, 300);
  private final FakeContext sites = new FakeContext(Domain.SITES, 100, 100, 300, 100, 200, 300);

  @Test
  void drawAppends() {
    new DrawTool().pressed(polygon, polygon.spot(50, 200));
    assertThat(polygon.points().size()).isEqualTo(5);
    assertThat(polygon.points().x(4)).isEqualTo(50);
    assertThat(polygon.history.undoLabel()).contains("Draw Vertex v4");
  }

  @Test
  void drawAddsNothingWhereASiteIs() {
    new DrawTool().pressed(sites, sites.spot(300, 100));
    assertThat(sites.points().size()).isEqualTo(3);
    assertThat(sites.said).contains("v1 is already there");
  }

  @Test
  void deleteTakesTheVertexWithinReach() {
    new DeleteTool().pressed(polygon, polygon.spot(304, 296));
    assertThat(polygon.points()).isEqualTo(Points.ofPairs(100, 100, 300, 100, 100, 300));
  }

  @Test
  void deleteOfNothingSaysSo() {
    new DeleteTool().pressed(polygon, polygon.spot(200, 200));
    assertThat(polygon.points().size()).isEqualTo(4);
    assertThat(polygon.said).contains("no vertex");
  }

  @Test
  void reachIsMeasuredOnTheScreen() {
    polygon.viewport = Viewport.IDENTITY.zoomed(10, 0, 0);
    new DeleteTool().pressed(polygon, polygon.spot(1040, 1000));
    assertThat(polygon.points().size()).isEqualTo(4);
    new DeleteTool().pressed(polygon, polygon.spot(1005, 1000));
    assertThat(polygon.points().size()).isEqualTo(3);
  }

  @Test
  void aDragIsShownAndBecomesOneEdit() {
    EditTool tool = new EditTool();
    tool.pressed(polygon, polygon.spot(302, 101));
    tool.dragged(polygon, polygon.spot(350, 150));
    assertThat(polygon.preview).isEqualTo(polygon.points().moved(1, 348, 149));
    tool.dragged(polygon, polygon.spot(402, 81));
    tool.released(polygon, polygon.spot(402, 81));
    assertThat(polygon.points().x(1)).isEqualTo(400);
    assertThat(polygon.points().y(1)).isEqualTo(80);
    polygon.history.undo();
    assertThat(polygon.history.undoLabel()).isEmpty();
  }

  @Test
  void aClickOnAVertexWithoutADragChangesNothing() {
    EditTool tool = new EditTool();
    tool.pressed(polygon, polygon.spot(302, 101));
    tool.released(polygon, polygon.spot(302, 101));
    assertThat(polygon.history.undoLabel()).isEmpty();
  }

  @Test
  void aDragGivenUpChangesNothing() {
    EditTool tool = new EditTool();
    tool.pressed(polygon, polygon.spot(300, 100));
    tool.dragged(polygon, polygon.spot(350, 150));
    assertThat(tool.cancelled(polygon)).isTrue();
    tool.released(polygon, polygon.spot(350, 150));
    assertThat(polygon.preview).isNull();
    assertThat(polygon.history.undoLabel()).isEmpty();
    assertThat(tool.cancelled(polygon)).isFalse();
  }

  @Test
  void anUndoDuringADragEndsIt() {
    new DrawTool().pressed(polygon, polygon.spot(50, 200));
    EditTool tool = new EditTool();
    tool.pressed(polygon, polygon.spot(50, 200));
    polygon.history.undo();
    tool.dragged(polygon, polygon.spot(60, 210));
    tool.released(polygon, polygon.spot(60, 210));
    assertThat(polygon.points().size()).isEqualTo(4);
  }

  @Test
  void aSiteIsNotDroppedOnAnother() {
    EditTool tool = new EditTool();
    tool.pressed(sites, sites.spot(200, 300));
    tool.dragged(sites, sites.spot(300, 100));
    tool.released(sites, sites.spot(300, 100));
    assertThat(sites.history.undoLabel()).isEmpty();
    assertThat(sites.said).contains("v1 is already there");
  }

  @ParameterizedTest
  @CsvSource({"200, 105, 1, 200, 100", "290, 200, 2, 300, 200", "95, 222, 4, 100, 222"})
  void splitTakesTheClosestEdge(double x, double y, int vertex, double atX, double atY) {
    new SplitTool().pressed(polygon, polygon.spot(x, y));
    assertThat(polygon.points())
        .isEqualTo(
            Points.ofPairs(100, 100, 300, 100, 300, 300, 100, 300).inserted(vertex, atX, atY));
  }

  @Test
  void splitOfSitesTakesAnEdgeOfTheTriangulationAndAppends() {
    new SplitTool().pressed(sites, sites.spot(210, 104));
    assertThat(sites.points()).isEqualTo(Points.ofPairs(100, 100, 300, 100, 200, 300, 210, 100));
  }

  @Test
  void splitAtAnEndAddsNothing() {
    new SplitTool().pressed(polygon, polygon.spot(95, 95));
    assertThat(polygon.points().size()).isEqualTo(4);
    assertThat(polygon.said).contains("v0 is already there");
  }

  @Test
  void splitOfNothingSaysSo() {
    FakeContext one = new FakeContext(Domain.POLYGON, 5, 5);
    new SplitTool().pressed(one, one.spot(50, 50));
    assertThat(one.points().size()).isEqualTo(1);
    assertThat(one.said).contains("no edge");
  }

  @ParameterizedTest
  @CsvSource({
    "1, 123.4567, 123",
    "3, 123.4567, 123.5",
    "10, 123.4567, 123.5",
    "11, 123.4567, 123.46",
    "0.5, 123.4567, 123",
    "0.05, 123.4567, 120",
    "0.001, 123456.7, 123000"
  })
  void coordinatesAreRoundedToWhatAPixelCanTell(double scale, double value, double rounded) {
    Viewport view = Viewport.IDENTITY.zoomed(scale, 0, 0);
    assertThat(Spot.rounded(view, value)).isEqualTo(rounded);
  }

  @Test
  void aClickChangesTheWishFromEvenToOddToAnyAndBack() {
    WishTool tool = new WishTool();
    for (Wish expected : new Wish[] {Wish.ODD, Wish.ANY, Wish.EVEN, Wish.ODD}) {
      tool.pressed(sites, sites.spot(302, 99));
      assertThat(sites.document().wishes())
          .isEqualTo(ParityGoal.of(Wish.EVEN, expected, Wish.EVEN));
    }
    sites.history.undo();
    assertThat(sites.document().wishes()).isEqualTo(ParityGoal.allEven(3));
    assertThat(sites.history.undoLabel()).contains("Wish Parity v1");
  }

  @Test
  void aWishForNothingSaysSo() {
    new WishTool().pressed(polygon, polygon.spot(200, 200));
    assertThat(polygon.document().wishes()).isEqualTo(ParityGoal.allEven(4));
    assertThat(polygon.said).contains("no wish was changed");
  }

  @Test
  void hintsSayWhatTheNextClickWillDo() {
    DeleteTool delete = new DeleteTool();
    delete.moved(polygon, polygon.spot(300, 300));
    assertThat(delete.hint(polygon)).isEqualTo("Click to delete v2");
    SplitTool split = new SplitTool();
    split.moved(polygon, polygon.spot(200, 110));
    assertThat(split.hint(polygon)).isEqualTo("Click to split the edge v0–v1");
    WishTool wish = new WishTool();
    wish.moved(polygon, polygon.spot(300, 300));
    assertThat(wish.hint(polygon)).isEqualTo("v2 is wished even; click to wish it odd");
    EditTool edit = new EditTool();
    edit.pressed(polygon, polygon.spot(300, 300));
    assertThat(edit.hint(polygon)).contains("Esc puts it back");
  }

  @Test
  void anEdgeWithoutNumbersBesideItIsNotSplit() {
    double up = Math.nextUp(1.0);
    FakeContext context = new FakeContext(Domain.SITES, 1, 1, up, 1, 1, up, up, up);
    context.viewport = Viewport.IDENTITY.zoomed(1e15, 0, 0);
    context.viewport =
        context.viewport.panned(-context.viewport.screenX(1), -context.viewport.screenY(1));
    Points before = context.points();
    new SplitTool().pressed(context, context.spot(0.11, 0.01));
    assertThat(context.points()).isEqualTo(before);
    assertThat(context.said).startsWith("No number is near enough");
  }
}
