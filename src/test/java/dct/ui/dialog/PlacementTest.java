package dct.ui.dialog;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import org.junit.jupiter.api.Test;

/** Where windows lie on the screen. */
class PlacementTest {
  private static final Rectangle SCREEN = new Rectangle(0, 30, 1024, 738);

  @Test
  void aSmallDialogLiesOverTheMiddleOfItsWindow() {
    assertThat(Placement.over(new Dimension(100, 50), new Rectangle(200, 100, 300, 250), SCREEN))
        .isEqualTo(new Point(300, 200));
  }

  @Test
  void noDialogHangsOverAnEdgeOfTheScreen() {
    Dimension large = new Dimension(1000, 700);
    assertThat(Placement.over(large, new Rectangle(0, 30, 200, 200), SCREEN))
        .isEqualTo(new Point(0, 30));
    assertThat(Placement.over(large, new Rectangle(900, 700, 200, 200), SCREEN))
        .isEqualTo(new Point(24, 68));
    assertThat(Placement.over(SCREEN.getSize(), new Rectangle(500, 500, 100, 100), SCREEN))
        .isEqualTo(SCREEN.getLocation());
  }
}
