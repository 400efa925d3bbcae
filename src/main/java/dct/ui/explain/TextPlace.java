package dct.ui.explain;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToIntFunction;
import java.util.stream.Stream;

/** Finds a place for a text that speaks of a picture: beside its window, or over no vertex. */
final class TextPlace {

  private TextPlace() {}

  /**
   * Where the text goes: beside the window if there is room, else to a border of the picture or the
   * screen; among these the first place in which it covers no vertex, or else the fewest.
   *
   * @param sizes that the text may have, the best first
   * @param screen what of it can be used
   * @param window the window that holds the picture
   * @param picture where the picture is on the screen
   * @param vertices how many vertices are seen in a part of the screen
   */
  static Rectangle of(
      List<Dimension> sizes,
      Rectangle screen,
      Rectangle window,
      Rectangle picture,
      ToIntFunction<Rectangle> vertices) {
    return sizes.stream()
        .map(size -> within(screen, size))
        .flatMap(size -> places(size, screen, window, picture).stream())
        .filter(screen::contains)
        .distinct()
        .min(Comparator.comparingInt(vertices))
        .orElseThrow();
  }

  private static Dimension within(Rectangle screen, Dimension size) {
    return new Dimension(Math.min(size.width, screen.width), Math.min(size.height, screen.height));
  }

  private static List<Rectangle> places(
      Dimension size, Rectangle screen, Rectangle window, Rectangle picture) {
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
    for (int x : List.of(right, picture.x + picture.width, picture.x, left)) {
      Stream.of(low, high, bottom, top)
          .map(y -> new Rectangle(x, y, size.width, size.height))
          .forEach(places::add);
    }
    return places;
  }
}
