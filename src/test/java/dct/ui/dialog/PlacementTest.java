package dct.ui.dialog;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Where windows lie on the screen. */
class PlacementTest {
  private static final Rectangle SCREEN = new Rectangle(0, 30, 1024, 738);
  private static final Rectangle SECOND = new Rectangle(1920, 0, 1280, 1024);

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

  @Test
  void aWindowOfALargerScreenIsNoLargerThanThisOne() {
    assertThat(Placement.noLarger(new Rectangle(58, 66, 1278, 810), SCREEN)).isEqualTo(SCREEN);
    assertThat(Placement.noLarger(new Rectangle(58, 66, 1278, 500), SCREEN))
        .isEqualTo(new Rectangle(0, 66, 1024, 500));
    Rectangle fits = new Rectangle(700, 66, 600, 500);
    assertThat(Placement.noLarger(fits, SCREEN)).isEqualTo(fits);
  }

  @Test
  void aNewWindowIsAStepLowerAndFurtherRight() {
    assertThat(Placement.below(new Rectangle(100, 100, 600, 400), SCREEN))
        .isEqualTo(new Rectangle(136, 136, 600, 400));
    assertThat(Placement.below(new Rectangle(2000, 100, 900, 700), SECOND))
        .isEqualTo(new Rectangle(2036, 136, 900, 700));
  }

  @Test
  void noNewWindowHangsOverAnEdgeOfTheScreen() {
    for (Rectangle screen : List.of(SCREEN, SECOND)) {
      for (int x = -200; x < screen.width; x += 77) {
        for (int y = -100; y < screen.height; y += 77) {
          for (Dimension size :
              List.of(new Dimension(600, 400), screen.getSize(), new Dimension(1278, 850))) {
            Rectangle other = new Rectangle(screen.x + x, screen.y + y, size.width, size.height);
            Rectangle placed = Placement.below(other, screen);
            assertThat(screen.contains(placed)).as(other + " " + placed).isTrue();
            assertThat(placed.getLocation()).isNotEqualTo(other.getLocation());
          }
        }
      }
    }
  }

  @Test
  void overAWindowThatFillsTheScreenTheNewOneLeavesItsTitleInSight() {
    assertThat(Placement.below(SCREEN, SCREEN)).isEqualTo(new Rectangle(36, 66, 988, 702));
  }
}
