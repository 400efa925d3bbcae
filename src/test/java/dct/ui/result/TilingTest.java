package dct.ui.result;

import static org.assertj.core.api.Assertions.assertThat;

import dct.ui.result.Tiling.Obstacle;
import dct.ui.result.Tiling.Pair;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

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
}
