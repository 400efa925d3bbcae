package dct.ui.result;

import static org.assertj.core.api.Assertions.assertThat;

import dct.ui.result.Tiling.Obstacle;
import dct.ui.result.Tiling.Pair;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Where windows of results go, as rectangles. */
class TilingTest {
  private static final Rectangle SMALL = new Rectangle(0, 0, 1024, 768);
  private static final Rectangle LARGE = new Rectangle(0, 0, 1920, 1080);

  @Test
  void aWindowCoversNothingWhereThereIsRoom() {
    Rectangle owner = new Rectangle(0, 0, 1200, 800);
    Rectangle placed =
        Tiling.place(new Dimension(604, 530), LARGE, List.of(new Obstacle(owner, 1)));
    assertThat(placed.intersects(owner)).isFalse();
    assertThat(LARGE.contains(placed)).isTrue();
  }

  @Test
  void whatMattersLessIsCoveredFirst() {
    List<Obstacle> obstacles =
        List.of(new Obstacle(SMALL, 1), new Obstacle(new Rectangle(750, 0, 274, 768), 3));
    Rectangle placed = Tiling.place(new Dimension(604, 530), SMALL, obstacles);
    assertThat(placed.x + placed.width).isLessThanOrEqualTo(750);
  }

  @Test
  void noWindowLiesExactlyOnAnother() {
    List<Obstacle> obstacles = new ArrayList<>();
    for (int i = 0; i < 8; i++) {
      Rectangle placed = Tiling.place(new Dimension(604, 530), SMALL, obstacles);
      assertThat(SMALL.contains(placed)).isTrue();
      assertThat(obstacles)
          .extracting(o -> o.bounds().getLocation())
          .doesNotContain(placed.getLocation());
      obstacles.add(new Obstacle(placed, 4));
    }
  }

  @Test
  void halvesOfASmallScreenStandBesideEachOther() {
    Pair pair = Tiling.pair(new Rectangle(0, 234, 604, 530), SMALL);
    assertThat(pair.first().intersects(pair.second())).isFalse();
    assertThat(pair.first().getSize()).isEqualTo(pair.second().getSize());
    assertThat(SMALL.contains(pair.first())).isTrue();
    assertThat(SMALL.contains(pair.second())).isTrue();
  }

  @Test
  void theOldWindowStaysWhereThereIsRoomOnEitherSide() {
    Rectangle right = new Rectangle(1300, 100, 604, 530);
    Pair pair = Tiling.pair(right, LARGE);
    assertThat(pair.first()).isEqualTo(right);
    assertThat(pair.second()).isEqualTo(new Rectangle(696, 100, 604, 530));
  }

  @Test
  void picturesOfAStudyGetSmallerUntilTheyHaveRoom() {
    assertThat(Tiling.size(new Dimension(604, 530), 2, SMALL)).isEqualTo(new Dimension(512, 530));
    assertThat(Tiling.size(new Dimension(604, 530), 4, LARGE)).isEqualTo(new Dimension(604, 530));
    assertThat(Tiling.size(new Dimension(604, 530), 40, SMALL)).isEqualTo(new Dimension(320, 260));
  }

  /** A main window with its menus, tools and east panel, and the screen that it is on. */
  private record Desk(Rectangle screen, Rectangle window, List<Rectangle> controls) {
    static Desk of(Rectangle screen, Rectangle window) {
      return new Desk(
          screen,
          window,
          List.of(
              new Rectangle(window.x, window.y + 20, window.width, 55),
              new Rectangle(
                  window.x + window.width - 274, window.y + 75, 274, window.height - 75)));
    }

    List<Obstacle> obstacles(List<Rectangle> frames) {
      List<Obstacle> all = new ArrayList<>(List.of(new Obstacle(window, 1)));
      controls.forEach(control -> all.add(new Obstacle(control, 3)));
      frames.forEach(at -> all.add(new Obstacle(at, 4)));
      return all;
    }
  }

  static Stream<Desk> desks() {
    return Stream.of(
        Desk.of(SMALL, SMALL),
        Desk.of(new Rectangle(0, 0, 1400, 950), new Rectangle(60, 67, 1276, 810)),
        Desk.of(LARGE, new Rectangle(320, 120, 1276, 810)),
        Desk.of(new Rectangle(1920, 0, 1280, 1024), new Rectangle(1922, 100, 1276, 810)),
        Desk.of(new Rectangle(-1024, 24, 1024, 744), new Rectangle(-1024, 24, 1024, 744)));
  }

  @ParameterizedTest
  @MethodSource("desks")
  void noFrameCoversTheControlsHoweverManyThereAre(Desk desk) {
    List<Rectangle> frames = new ArrayList<>();
    for (int i = 0; i < 9; i++) {
      Rectangle placed =
          Tiling.place(new Dimension(604, 530), desk.screen, desk.controls, desk.obstacles(frames));
      assertThat(desk.screen.contains(placed)).isTrue();
      assertThat(desk.controls).noneMatch(placed::intersects);
      assertThat(frames).extracting(Rectangle::getLocation).doesNotContain(placed.getLocation());
      frames.add(placed);
    }
  }

  @ParameterizedTest
  @MethodSource("desks")
  void noPairCoversTheControls(Desk desk) {
    Rectangle old =
        Tiling.place(
            new Dimension(604, 530), desk.screen, desk.controls, desk.obstacles(List.of()));
    Pair pair = Tiling.pair(old, desk.screen, desk.controls, desk.obstacles(List.of(old)));
    for (Rectangle placed : List.of(pair.first(), pair.second())) {
      assertThat(desk.screen.contains(placed)).isTrue();
      assertThat(desk.controls).noneMatch(placed::intersects);
    }
    assertThat(pair.first().intersects(pair.second())).isFalse();
  }

  @Test
  void aFrameGoesBesideTheWindowWhereThatIsFree() {
    Desk desk = Desk.of(LARGE, new Rectangle(0, 0, 1276, 810));
    Rectangle placed =
        Tiling.place(new Dimension(604, 530), LARGE, desk.controls, desk.obstacles(List.of()));
    assertThat(placed).isEqualTo(new Rectangle(1276, 0, 604, 530));
  }
}
