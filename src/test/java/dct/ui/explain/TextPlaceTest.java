package dct.ui.explain;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Where the text of an explanation goes, as rectangles. */
class TextPlaceTest {
  private static final Rectangle SCREEN = new Rectangle(0, 0, 1024, 768);
  private static final Rectangle PICTURE = new Rectangle(0, 76, 750, 656);
  private static final List<Dimension> SIZES =
      List.of(new Dimension(460, 440), new Dimension(274, 600));

  @Test
  void itGoesBesideAWindowThatLeavesRoom() {
    Rectangle window = new Rectangle(10, 20, 500, 700);
    assertThat(place(window, List.of())).isEqualTo(new Rectangle(510, 20, 460, 440));
    Rectangle atTheRight = new Rectangle(524, 20, 500, 700);
    assertThat(place(atTheRight, List.of())).isEqualTo(new Rectangle(64, 20, 460, 440));
  }

  @Test
  void itCoversNoVertexWhereItCanBeAvoided() {
    List<Point> hull = List.of(new Point(20, 300), new Point(730, 700), new Point(700, 100));
    Rectangle place = place(SCREEN, hull);
    assertThat(hull).noneMatch(place::contains);
    assertThat(SCREEN.contains(place)).isTrue();
  }

  @Test
  void itGetsNarrowerRatherThanCoverAVertex() {
    List<Point> many =
        List.of(
            new Point(740, 700),
            new Point(740, 500),
            new Point(740, 300),
            new Point(740, 100),
            new Point(10, 700),
            new Point(10, 500),
            new Point(10, 300),
            new Point(10, 100));
    assertThat(place(SCREEN, many)).isEqualTo(new Rectangle(750, 132, 274, 600));
  }

  @Test
  void itCoversAsFewAsItCan() {
    List<Point> many = List.of(new Point(760, 400), new Point(10, 400), new Point(11, 400));
    Rectangle place = place(SIZES.subList(0, 1), SCREEN, List.of(), many).text();
    assertThat(many.stream().filter(place::contains)).hasSizeLessThan(2);
  }

  @Test
  void itCoversNoFrameOfAResultWhereThereIsRoomBesideIt() {
    Rectangle frame = new Rectangle(0, 100, 604, 530);
    TextPlace place = place(List.of(new Dimension(420, 440)), SCREEN, List.of(frame), List.of());
    assertThat(place.text().intersects(frame)).isFalse();
    assertThat(place.frames()).containsExactly(frame);
    Rectangle middle = new Rectangle(280, 0, 600, 768);
    TextPlace left = place(SIZES, SCREEN, List.of(middle), List.of(new Point(100, 300)));
    assertThat(left.text())
        .as("rather over a vertex than over a frame")
        .matches(text -> text.x + text.width <= 280);
    assertThat(left.frames()).containsExactly(middle);
  }

  @Test
  void framesAreMovedOrGetNarrowerWhereTheyLeaveNoRoom() {
    Rectangle wide = new Rectangle(200, 50, 700, 600);
    TextPlace moved = place(SIZES, wide, List.of(wide), List.of());
    assertThat(moved.text()).isEqualTo(new Rectangle(750, 50, 274, 600));
    assertThat(moved.frames()).containsExactly(new Rectangle(50, 50, 700, 600));

    Rectangle first = new Rectangle(0, 50, 412, 600);
    Rectangle second = new Rectangle(412, 50, 412, 700);
    TextPlace narrower = place(SIZES, second, List.of(first, second), List.of());
    assertThat(narrower.text()).isEqualTo(new Rectangle(750, 50, 274, 600));
    assertThat(narrower.frames())
        .containsExactly(new Rectangle(0, 50, 375, 600), new Rectangle(375, 50, 375, 700));
  }

  private static Rectangle place(Rectangle window, List<Point> vertices) {
    return place(SIZES, window, List.of(), vertices).text();
  }

  private static TextPlace place(
      List<Dimension> sizes, Rectangle window, List<Rectangle> frames, List<Point> vertices) {
    TextPlace.Desk desk = new TextPlace.Desk(SCREEN, window, PICTURE, frames);
    return TextPlace.of(sizes, SIZES.get(1), desk, r -> count(r, vertices));
  }

  private static int count(Rectangle part, List<Point> vertices) {
    return (int) vertices.stream().filter(part::contains).count();
  }
}
