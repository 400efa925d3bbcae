package dct.ui.explain;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.ToIntFunction;

/**
 * Finds a place for a text that speaks of a picture: beside its window, or over no vertex; and over
 * no frame of a result, for which the frames may have to move.
 *
 * @param text where the text goes
 * @param frames where the frames go then, in their order
 */
record TextPlace(Rectangle text, List<Rectangle> frames) {

  /**
   * What is on the screen.
   *
   * @param screen what of it can be used
   * @param window the window that holds the picture
   * @param picture where the picture is
   * @param frames the frames of results; the window may be one of them
   */
  record Desk(Rectangle screen, Rectangle window, Rectangle picture, List<Rectangle> frames) {

    /** How many pixels of frames a text would cover. */
    private long covered(Rectangle text) {
      return frames.stream()
          .map(text::intersection)
          .filter(common -> !common.isEmpty())
          .mapToLong(common -> (long) common.width * common.height)
          .sum();
    }
  }

  /**
   * Where the text goes: beside the window if there is room, else to a border of the picture, the
   * screen or a frame; among these to the first place in which it covers no frame and no vertex, or
   * else the fewest vertices. Where every place covers a frame, room is made on the right.
   *
   * @param sizes that the text may have, the best first
   * @param aside its size where room is made for it
   * @param vertices how many vertices are seen in a part of the screen
   */
  static TextPlace of(
      List<Dimension> sizes, Dimension aside, Desk desk, ToIntFunction<Rectangle> vertices) {
    List<Rectangle> free =
        sizes.stream()
            .map(size -> within(desk.screen, size))
            .flatMap(size -> places(size, desk).stream())
            .filter(desk.screen::contains)
            .filter(place -> desk.covered(place) == 0)
            .distinct()
            .toList();
    return best(free, vertices)
        .map(place -> new TextPlace(place, desk.frames))
        .orElseGet(() -> onTheRight(within(desk.screen, aside), desk));
  }

  /** The first place over no vertex, or else the one over the fewest; nothing if there is none. */
  private static Optional<Rectangle> best(
      List<Rectangle> places, ToIntFunction<Rectangle> vertices) {
    return places.stream()
        .filter(place -> vertices.applyAsInt(place) == 0)
        .findFirst()
        .or(() -> places.stream().min(Comparator.comparingInt(vertices)));
  }

  private static Dimension within(Rectangle screen, Dimension size) {
    return new Dimension(Math.min(size.width, screen.width), Math.min(size.height, screen.height));
  }

  private static List<Rectangle> places(Dimension size, Desk desk) {
    Rectangle screen = desk.screen;
    Rectangle window = desk.window;
    Rectangle picture = desk.picture;
    int left = screen.x;
    int right = screen.x + screen.width - size.width;
    int top = screen.y;
    int bottom = screen.y + screen.height - size.height;
    int beside = Math.max(top, Math.min(window.y, bottom));
    List<Rectangle> places = new ArrayList<>();
    places.add(new Rectangle(window.x + window.width, beside, size.width, size.height));
    places.add(new Rectangle(window.x - size.width, beside, size.width, size.height));
    int low = Math.max(top, Math.min(picture.y + picture.height - size.height, bottom));
    int high = Math.max(top, Math.min(picture.y, bottom));
    List<Integer> xs = new ArrayList<>(List.of(right, picture.x + picture.width, picture.x, left));
    List<Integer> ys = new ArrayList<>(List.of(low, high, bottom, top));
    for (Rectangle frame : desk.frames) {
      xs.addAll(List.of(frame.x + frame.width, frame.x - size.width));
      ys.addAll(List.of(frame.y + frame.height, frame.y - size.height));
    }
    for (int x : xs) {
      ys.forEach(y -> places.add(new Rectangle(x, y, size.width, size.height)));
    }
    return places;
  }

  /** The text at the right of the screen, and the frames in what it leaves. */
  private static TextPlace onTheRight(Dimension size, Desk desk) {
    Rectangle screen = desk.screen;
    int x = screen.x + screen.width - size.width;
    int y = Math.min(desk.window.y, screen.y + screen.height - size.height);
    Rectangle text = new Rectangle(x, Math.max(screen.y, y), size.width, size.height);
    return new TextPlace(text, moved(desk.frames, screen.x, x));
  }

  /**
   * The frames moved to the left until they end where the room does, or made narrower together
   * where that is not enough: what stood beside each other still does.
   */
  private static List<Rectangle> moved(List<Rectangle> frames, int left, int right) {
    int from = frames.stream().mapToInt(frame -> frame.x).min().orElse(left);
    int to = frames.stream().mapToInt(frame -> frame.x + frame.width).max().orElse(right);
    int width = Math.min(to - from, right - left);
    int start = Math.max(left, Math.min(from, right - width));
    double scale = (double) width / (to - from);
    return frames.stream()
        .map(
            frame -> {
              int x = start + (int) Math.round(scale * (frame.x - from));
              int end = start + (int) Math.round(scale * (frame.x + frame.width - from));
              return new Rectangle(x, frame.y, end - x, frame.height);
            })
        .toList();
  }
}
