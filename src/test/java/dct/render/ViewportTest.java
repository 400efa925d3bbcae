package dct.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.geometry.Box;
import dct.core.geometry.Points;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ViewportTest {

  @Test
  void identityIsThePixelsOfTheCanvas() {
    assertThat(Viewport.IDENTITY.screenX(17)).isEqualTo(17);
    assertThat(Viewport.IDENTITY.screenY(23)).isEqualTo(23);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void modelUndoesScreen(boolean yUp) {
    Viewport view = Viewport.fit(new Box(-3, 5, 40, 90), 800, 600, 20, yUp).zoomed(1.7, 100, 30);
    assertThat(view.modelX(view.screenX(12.5))).isCloseTo(12.5, within(1e-12));
    assertThat(view.modelY(view.screenY(12.5))).isCloseTo(12.5, within(1e-12));
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void zoomKeepsThePointUnderTheMouse(boolean yUp) {
    Viewport view = Viewport.fit(new Box(0, 0, 10, 10), 800, 600, 20, yUp);
    Viewport zoomed = view.zoomed(3, 200, 150);
    assertThat(zoomed.modelX(200)).isCloseTo(view.modelX(200), within(1e-12));
    assertThat(zoomed.modelY(150)).isCloseTo(view.modelY(150), within(1e-12));
    assertThat(zoomed.scale()).isCloseTo(3 * view.scale(), within(1e-9));
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void panMovesThePictureWithTheMouse(boolean yUp) {
    Viewport view = Viewport.fit(new Box(0, 0, 10, 10), 800, 600, 20, yUp);
    Viewport panned = view.panned(30, -40);
    assertThat(panned.screenX(5)).isCloseTo(view.screenX(5) + 30, within(1e-9));
    assertThat(panned.screenY(5)).isCloseTo(view.screenY(5) - 40, within(1e-9));
  }

  @Test
  void fitTouchesTheMarginOnTheTighterSides() {
    Viewport view = Viewport.fit(new Box(0, 0, 100, 10), 800, 600, 50, false);
    assertThat(view.screenX(0)).isCloseTo(50, within(1e-9));
    assertThat(view.screenX(100)).isCloseTo(750, within(1e-9));
    assertThat(view.screenY(5)).isCloseTo(300, within(1e-9));
  }

  /** The middle of a shape that is an odd number of ulps wide is no number. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void aShapeOfOneUlpLiesInTheMiddle(boolean yUp) {
    double next = Math.nextUp(1.0);
    Viewport view = Viewport.fit(new Box(1, 1, next, next), 1000, 700, 40, yUp);
    assertThat(view.screenX(1)).isCloseTo(190, within(1e-6));
    assertThat(view.screenX(next)).isCloseTo(810, within(1e-6));
    assertThat(view.screenY(yUp ? next : 1)).isCloseTo(40, within(1e-6));
    assertThat(view.screenY(yUp ? 1 : next)).isCloseTo(660, within(1e-6));
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void amongNeighbouringNumbersZoomAndAxisKeepThePlaceToo(boolean yUp) {
    double next = Math.nextUp(1.0);
    Viewport view = Viewport.fit(new Box(1, 1, next, next), 1000, 700, 40, yUp);
    Viewport zoomed = view.zoomed(2, 400, 300);
    assertThat(zoomed.screenX(1)).isCloseTo(400 + 2 * (view.screenX(1) - 400), within(1e-6));
    assertThat(zoomed.screenY(1)).isCloseTo(300 + 2 * (view.screenY(1) - 300), within(1e-6));
    Viewport turned = view.flipped(400, 300);
    assertThat(turned.screenX(1)).isCloseTo(view.screenX(1), within(1e-6));
    assertThat(turned.screenY(1)).isCloseTo(600 - view.screenY(1), within(1e-6));
  }

  @Test
  void yUpPutsTheGreaterYHigher() {
    Viewport view = Viewport.fit(new Box(0, 0, 10, 10), 800, 600, 20, true);
    assertThat(view.screenY(10)).isLessThan(view.screenY(0));
  }

  @Test
  void aSinglePointIsShownInTheMiddle() {
    Viewport view = Viewport.fit(Box.of(Points.ofPairs(7, 9)), 800, 600, 20, false);
    assertThat(view.screenX(7)).isEqualTo(400);
    assertThat(view.screenY(9)).isEqualTo(300);
    assertThat(view.scale()).isEqualTo(1);
  }

  @Test
  void hugeAndTinyCoordinatesStayOnTheScreen() {
    for (double size : new double[] {Double.MAX_VALUE, 1e-200}) {
      Points points = Points.ofPairs(-size, -size, size, size);
      Viewport view = Viewport.fit(Box.of(points), 800, 600, 20, false);
      assertThat(view.screenY(-size)).as("top for %s", size).isCloseTo(20, within(1e-6));
      assertThat(view.screenY(size)).as("bottom for %s", size).isCloseTo(580, within(1e-6));
    }
  }

  @Test
  void zoomStopsBeforeTheNumbersRunOut() {
    Viewport view = Viewport.IDENTITY;
    for (int i = 0; i < 5000; i++) {
      view = view.zoomed(2, 10, 10);
    }
    assertThat(view.scale()).isFinite();
    assertThat(view.screenX(10)).isFinite();
  }
}
