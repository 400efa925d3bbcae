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
  void aWindowComesBackOnTheScreenThatItWasOn() {
    Rectangle first = new Rectangle(0, 30, 1920, 1050);
    Rectangle above = new Rectangle(0, -1024, 1280, 1024);
    List<Rectangle> all = List.of(first, SECOND, above);
    for (Rectangle window :
        List.of(
            new Rectangle(58, 66, 1278, 810),
            new Rectangle(1950, 20, 1200, 900),
            new Rectangle(1800, 50, 800, 600), // more of it is on the second screen
            new Rectangle(20, -1000, 700, 500))) {
      assertThat(Placement.placed(window, all)).contains(window);
    }
    Rectangle large = new Rectangle(1950, 0, 1900, 900);
    assertThat(Placement.placed(large, all)).contains(new Rectangle(1920, 0, 1280, 900));
  }

  @Test
  void aWindowWhoseScreenIsGoneDoesNotComeBackThere() {
    assertThat(Placement.placed(new Rectangle(1950, 20, 1200, 900), List.of(SCREEN))).isEmpty();
    assertThat(Placement.placed(new Rectangle(960, 100, 800, 600), List.of(SCREEN))).isEmpty();
    Rectangle partly = new Rectangle(900, 100, 800, 600);
    assertThat(Placement.placed(partly, List.of(SCREEN))).contains(partly);
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
