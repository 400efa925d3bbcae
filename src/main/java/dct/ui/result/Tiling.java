package dct.ui.result;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.Comparator;
import java.util.List;
import java.util.NavigableSet;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Stream;

/** Finds places for windows such that they cover as little as possible of what matters. */
public final class Tiling {
  private static final int STEP = 36; // apart from each other, so that titles can be seen
  private static final int LEAST_WIDTH = 320;
  private static final int LEAST_HEIGHT = 260;

  private Tiling() {}

  /**
   * Something on the screen.
   *
   * @param bounds where it is
   * @param weight how much a pixel of it matters
   */
  public record Obstacle(Rectangle bounds, int weight) {}

  /**
   * Two windows side by side.
   *
   * @param first the bounds of the one on the left
   * @param second the bounds of the other, of the same size
   */
  public record Pair(Rectangle first, Rectangle second) {}

  /** The size of each of so many windows such that all have room on the screen, if they can. */
  public static Dimension size(Dimension wished, int windows, Rectangle screen) {
    int columns = (int) Math.ceil(Math.sqrt(windows));
    int rows = (windows + columns - 1) / columns;
    return new Dimension(
        Math.min(wished.width, Math.max(LEAST_WIDTH, screen.width / columns)),
        Math.min(wished.height, Math.max(LEAST_HEIGHT, screen.height / rows)));
  }

  /**
   * The place of a window of this size: in free room, or else where it covers the least, but none
   * of the controls, for which it may have to be smaller.
   *
   * @param controls what should not be covered
   */
  public static Rectangle place(
      Dimension size, Rectangle screen, List<Rectangle> controls, List<Obstacle> obstacles) {
    Rectangle free = place(size, screen, obstacles);
    if (covered(free, obstacles) == 0) {
      return free;
    }
    Rectangle room = without(screen, controls);
    int width = Math.min(size.width, room.width);
    int height = Math.min(size.height, room.height);
    return place(new Dimension(width, height), room, obstacles);
  }

  /** The largest part of a screen that holds none of these; all of it if each part is too small. */
  static Rectangle without(Rectangle screen, List<Rectangle> controls) {
    TreeSet<Integer> xs = new TreeSet<>(List.of(screen.x, screen.x + screen.width));
    TreeSet<Integer> ys = new TreeSet<>(List.of(screen.y, screen.y + screen.height));
    for (Rectangle control : controls) {
      Rectangle seen = control.intersection(screen);
      if (!seen.isEmpty()) {
        xs.addAll(List.of(seen.x, seen.x + seen.width));
        ys.addAll(List.of(seen.y, seen.y + seen.height));
      }
    }
    return spans(xs, LEAST_WIDTH)
        .flatMap(x -> spans(ys, LEAST_HEIGHT).map(y -> part(x, y)))
        .filter(part -> controls.stream().noneMatch(part::intersects))
        .max(Comparator.comparingInt(part -> part.width * part.height))
        .orElse(screen);
  }

  /** The pairs of these places that are so far apart or more. */
  private static Stream<Point> spans(NavigableSet<Integer> places, int least) {
    return places.stream()
        .flatMap(from -> places.tailSet(from + least).stream().map(to -> new Point(from, to)));
  }

  private static Rectangle part(Point x, Point y) {
    return new Rectangle(x.x, y.x, x.y - x.x, y.y - y.x);
  }

  /**
   * The place on the screen where a window of this size covers the least; of several, the highest,
   * and of these the leftmost. Quadratic in the number of obstacles, and each is looked at again.
   */
  static Rectangle place(Dimension size, Rectangle screen, List<Obstacle> obstacles) {
    TreeSet<Integer> xs = new TreeSet<>();
    TreeSet<Integer> ys = new TreeSet<>();
    addPlaces(xs, screen.x, screen.width, size.width);
    addPlaces(ys, screen.y, screen.height, size.height);
    for (Obstacle obstacle : obstacles) {
      Rectangle at = obstacle.bounds();
      Stream.of(at.x - size.width, at.x + STEP, at.x + at.width)
          .forEach(x -> xs.add(within(x, screen.x, screen.width, size.width)));
      Stream.of(at.y - size.height, at.y, at.y + STEP, at.y + at.height)
          .forEach(y -> ys.add(within(y, screen.y, screen.height, size.height)));
    }
    return ys.stream()
        .flatMap(y -> xs.stream().map(x -> new Point(x, y)))
        .map(at -> new Rectangle(at, size))
        .min(Comparator.comparingLong(bounds -> covered(bounds, obstacles)))
        .orElseThrow();
  }

  private static void addPlaces(NavigableSet<Integer> places, int from, int length, int size) {
    places.add(from);
    places.add(within(from + length - size, from, length, size));
  }

  private static int within(int at, int from, int length, int size) {
    return Math.max(from, Math.min(at, from + length - size));
  }

  private static long covered(Rectangle bounds, List<Obstacle> obstacles) {
    long sum = 0;
    for (Obstacle obstacle : obstacles) {
      Rectangle common = bounds.intersection(obstacle.bounds());
      if (!common.isEmpty()) {
        sum += (long) common.width * common.height * obstacle.weight();
      }
      if (bounds.getLocation().equals(obstacle.bounds().getLocation())) {
        sum += (long) bounds.width * bounds.height * obstacle.weight(); // would hide its title
      }
    }
    return sum;
  }

  /**
   * The places of a window and of a new one of its size beside it: the first stays where it is if
   * there is room for the new one on one of its sides, or anywhere. Else they share what is left of
   * the screen beside the controls.
   *
   * @param controls what should not be covered
   * @param obstacles what else is on the screen, the first window included
   */
  public static Pair pair(
      Rectangle first, Rectangle screen, List<Rectangle> controls, List<Obstacle> obstacles) {
    Pair adjacent = pair(first, screen);
    if (adjacent.first().equals(first)
        && controls.stream().noneMatch(adjacent.second()::intersects)) {
      return adjacent;
    }
    Rectangle free = place(first.getSize(), screen, obstacles);
    return covered(free, obstacles) == 0
        ? new Pair(first, free)
        : pair(first, without(screen, controls));
  }

  /**
   * The places of a window and of a new one of its size beside it: the first stays where it is if
   * there is room on one of its sides, or else moves just as far as it has to; where two of its
   * width have no room beside each other, both become narrower.
   */
  static Pair pair(Rectangle first, Rectangle screen) {
    int width = Math.min(first.width, screen.width / 2);
    int height = Math.min(first.height, screen.height);
    int y = within(first.y, screen.y, screen.height, height);
    Optional<Integer> beside =
        Stream.of(first.x + first.width, first.x - width)
            .filter(x -> x >= screen.x && x + width <= screen.x + screen.width)
            .findFirst();
    boolean stays = beside.isPresent() && width == first.width && first.x >= screen.x;
    int x = stays ? first.x : within(first.x, screen.x, screen.width, 2 * width);
    int second = stays ? beside.get() : x + width;
    return new Pair(new Rectangle(x, y, width, height), new Rectangle(second, y, width, height));
  }
}
