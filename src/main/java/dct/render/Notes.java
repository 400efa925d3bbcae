package dct.render;

import dct.core.geometry.Box;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * What is written in the corners of a picture, and in which: the counts, the mouse's coordinates,
 * and on request a legend; immutable.
 *
 * <p>Each stands in the corner of its own, the thesis's, unless it covers vertices there and fewer
 * elsewhere. It comes back when nothing is near its own corner any more: so it does not jump to and
 * fro while a vertex is dragged about its border.
 *
 * @param legend whether there is one
 * @param counts where the counts are
 * @param coordinates where the mouse's coordinates are
 * @param key where the legend is
 */
public record Notes(boolean legend, Corner counts, Corner coordinates, Corner key) {
  private static final int COORDINATES = 24; // characters that room is kept for
  private static final double NEAR = 6; // pixels; dots reach so far
  private static final double AROUND = 40; // pixels that are free before a note comes back
  private static final int ENOUGH = 1000; // vertices are not counted further

  /** The corners of their own: that of the thesis for counts and coordinates. */
  public static Notes at(boolean legend) {
    return new Notes(legend, Corner.UPPER_RIGHT, Corner.UPPER_LEFT, Corner.LOWER_LEFT);
  }

  /** The same with or without a legend. */
  public Notes withLegend(boolean wished) {
    return new Notes(wished, counts, coordinates, key);
  }

  /** The same notes, those that cover vertices of this picture moved to where there are fewer. */
  public Notes placed(Scene scene, Viewport view, Box screen) {
    if (!scene.isAtHand()) {
      return this;
    }
    Search search = new Search(scene, view, Caption.room(screen));
    List<String> lines = scene.counts();
    double height = Caption.height(Math.max(1, lines.size()));
    Corner first = search.corner(counts, Caption.width(lines), height, Corner.UPPER_RIGHT);
    Corner second =
        search.corner(
            coordinates, Caption.width(COORDINATES), Caption.height(1), Corner.UPPER_LEFT);
    Legend shown = new Legend(scene);
    Corner third =
        legend ? search.corner(key, shown.width(), shown.height(), Corner.LOWER_LEFT) : key;
    return new Notes(legend, first, second, third);
  }

  /**
   * The viewport that shows the whole scene as large as it fits on a screen of this size, beside
   * its notes and with a margin on each side; actual size if there are no vertices.
   */
  public Viewport fitted(Scene scene, double width, double height, boolean yUp) {
    Viewport plain = ScenePainter.fitted(scene, width, height, yUp);
    Legend shown = new Legend(scene);
    if (!legend || shown.isEmpty() || isClear(scene, plain, new Box(0, 0, width, height), shown)) {
      return plain;
    }
    double strip = Math.min(shown.width(), width / 2);
    return ScenePainter.fitted(scene, width - strip, height, yUp).panned(strip, 0);
  }

  private boolean isClear(Scene scene, Viewport view, Box screen, Legend shown) {
    Corner corner = at(true).placed(scene, view, screen).key;
    Box box = corner.box(Caption.room(screen), shown.width(), shown.height());
    return scene.verticesIn(view, box.grown(NEAR), 1) == 0;
  }

  /**
   * Writes them.
   *
   * @param mouse its coordinates; empty while it is elsewhere
   */
  public void paint(Scene scene, Box screen, Pen pen, String mouse) {
    if (legend) {
      Legend shown = new Legend(scene);
      if (!shown.isEmpty()) {
        shown.paint(pen, screen, key);
      }
    }
    Caption.paint(pen, screen, counts, scene.counts());
    Caption.paint(pen, screen, coordinates, mouse.isEmpty() ? List.of() : List.of(mouse));
  }

  /** Gives away the corners, each once. */
  private static final class Search {
    private final Scene scene;
    private final Viewport view;
    private final Box room;
    private final List<Corner> free = new ArrayList<>(Arrays.asList(Corner.values()));

    Search(Scene scene, Viewport view, Box room) {
      this.scene = scene;
      this.view = view;
      this.room = room;
    }

    /** Takes a corner for a note of this size that was in this one and likes that one best. */
    Corner corner(Corner now, double width, double height, Corner own) {
      Corner best =
          free.stream()
              .min(
                  Comparator.comparingInt((Corner c) -> vertices(c, width, height, NEAR))
                      .thenComparing(c -> c != own))
              .orElseThrow();
      Corner taken = best;
      if (free.contains(own) && vertices(own, width, height, AROUND) == 0) {
        taken = own;
      } else if (free.contains(now) && !isMuchBetter(best, now, width, height)) {
        taken = now;
      }
      free.remove(taken);
      return taken;
    }

    private boolean isMuchBetter(Corner best, Corner now, double width, double height) {
      int there = vertices(best, width, height, NEAR);
      int here = vertices(now, width, height, NEAR);
      return there == 0 ? here > 0 : 2 * there < here;
    }

    private int vertices(Corner corner, double width, double height, double around) {
      return scene.verticesIn(view, corner.box(room, width, height).grown(around), ENOUGH);
    }
  }
}
