package dct.render;

import dct.core.geometry.Box;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * What is written in the corners of a picture, and in which: the counts, the mouse's coordinates,
 * and on request a legend; immutable.
 *
 * <p>Each stands in the corner of its own, the thesis's, unless it covers a vertex there; then it
 * moves to a corner where it covers none, and comes back when nothing is near its own corner any
 * more: so it does not jump to and fro while a vertex is dragged about its border. What covers a
 * vertex in every corner is away: it is not painted, and others may write its words elsewhere.
 *
 * @param legend whether there is one
 * @param counts where the counts are
 * @param coordinates where the mouse's coordinates are
 * @param key where the legend is
 * @param away what has no room in any corner
 */
public record Notes(boolean legend, Corner counts, Corner coordinates, Corner key, Set<Note> away) {
  private static final int COORDINATES = 24; // characters that room is kept for
  private static final int LINES_OF_FLIPS = 2; // before and after
  private static final double NEAR = 6; // pixels; dots reach so far

  private static final double BACK = 12; // pixels that are free before one is no longer away

  /** What is written in a corner. */
  public enum Note {
    COUNTS(Corner.UPPER_RIGHT),
    COORDINATES(Corner.UPPER_LEFT),
    LEGEND(Corner.LOWER_LEFT);

    private final Corner own;

    Note(Corner own) {
      this.own = own;
    }
  }

  /** Notes that stay as they are. */
  public Notes {
    away = Set.copyOf(away);
  }

  /** The corners of their own: that of the thesis for counts and coordinates. */
  public static Notes at(boolean legend) {
    return new Notes(
        legend, Note.COUNTS.own, Note.COORDINATES.own, Note.LEGEND.own, EnumSet.noneOf(Note.class));
  }

  /** The same with or without a legend. */
  public Notes withLegend(boolean wished) {
    return new Notes(wished, counts, coordinates, key, away);
  }

  /**
   * The same notes, those that cover vertices of this picture moved to where there are none, or
   * away. While the vertices of a large scene are not sorted yet, the notes stay where they are
   * unless all have room outside the box round the vertices.
   */
  public Notes placed(Scene scene, Viewport view, Box screen) {
    Search search = new Search(scene, view, Caption.room(screen));
    List<String> lines = Caption.folded(scene.counts(), screen);
    int count = Math.max(1, lines.size());
    Corner first =
        search.corner(
            Note.COUNTS, counts, Caption.width(lines), Caption.height(count), around(count));
    Corner second =
        search.corner(
            Note.COORDINATES,
            coordinates,
            Caption.width(COORDINATES),
            Caption.height(1),
            around(1));
    Legend shown = new Legend(scene);
    Corner third =
        legend && !shown.isEmpty()
            ? search.corner(Note.LEGEND, key, shown.width(), shown.height(), around(1))
            : key;
    boolean known = search.away.isEmpty() || scene.isAtHand();
    return known ? new Notes(legend, first, second, third, search.away) : this;
  }

  /**
   * Pixels that are free before a note of so many lines comes back: fitted with room for flips, a
   * drawing leaves one more below them.
   */
  private static double around(int lines) {
    double room = Caption.height(Math.max(LINES_OF_FLIPS, lines));
    return room - Caption.height(lines) + ScenePainter.FIT_GAP - 1;
  }

  /** Whether each has room in a corner of this picture. */
  public boolean haveRoom(Scene scene, Viewport view, Box screen) {
    Notes unsure = new Notes(legend, counts, coordinates, key, EnumSet.allOf(Note.class));
    return unsure.placed(scene, view, screen).away.isEmpty();
  }

  /**
   * The viewport that shows the whole scene as large as it fits on a screen of this size, beside
   * its notes and with a margin on each side; actual size if there are no vertices.
   */
  public Viewport fitted(Scene scene, double width, double height, boolean yUp) {
    return fitted(scene, 0, width, height, yUp);
  }

  /** The same, with room for the counts that a scene of the same points has after flips. */
  public Viewport fittedForFlips(Scene scene, double width, double height, boolean yUp) {
    return fitted(scene, LINES_OF_FLIPS, width, height, yUp);
  }

  private Viewport fitted(Scene scene, int lines, double width, double height, boolean yUp) {
    Viewport plain = ScenePainter.fitted(scene, lines, width, height, yUp);
    Legend shown = new Legend(scene);
    Box screen = new Box(0, 0, width, height);
    if (!legend || shown.isEmpty() || at(true).haveRoom(scene, plain, screen)) {
      return plain;
    }
    double strip = Math.min(shown.width(), width / 2);
    return ScenePainter.fitted(scene, lines, width - strip, height, yUp).panned(strip, 0);
  }

  /**
   * The words of what is away and not to be seen in the picture.
   *
   * @param mouse its coordinates; empty while it is elsewhere
   */
  public List<String> aside(Scene scene, String mouse) {
    Stream<String> coordinates = away.contains(Note.COORDINATES) ? Stream.of(mouse) : Stream.of();
    Stream<String> lines = away.contains(Note.COUNTS) ? scene.counts().stream() : Stream.of();
    Stream<String> legends =
        away.contains(Note.LEGEND) ? Stream.of("No room for the legend (F fits)") : Stream.of();
    return Stream.of(coordinates, lines, legends)
        .flatMap(words -> words)
        .filter(words -> !words.isEmpty())
        .toList();
  }

  /**
   * Writes them.
   *
   * @param mouse its coordinates; empty while it is elsewhere
   */
  public void paint(Scene scene, Box screen, Pen pen, String mouse) {
    if (legend && !away.contains(Note.LEGEND)) {
      Legend shown = new Legend(scene);
      if (!shown.isEmpty()) {
        shown.paint(pen, screen, key);
      }
    }
    if (!away.contains(Note.COUNTS)) {
      Caption.paint(pen, screen, counts, Caption.folded(scene.counts(), screen));
    }
    if (!away.contains(Note.COORDINATES) && !mouse.isEmpty()) {
      Caption.paint(pen, screen, coordinates, List.of(mouse));
    }
  }

  /** Gives away the corners, such that no two notes overlap. */
  private final class Search {
    private final Scene scene;
    private final Viewport view;
    private final Box room;
    private final Optional<Box> drawn; // the box round the vertices, on the screen
    private final List<Box> taken = new ArrayList<>();
    private final Set<Note> away = EnumSet.noneOf(Note.class);

    Search(Scene scene, Viewport view, Box room) {
      this.scene = scene;
      this.view = view;
      this.room = room;
      drawn = scene.bounds().map(view::screenBox);
    }

    /**
     * Takes a corner for a note of this size that was in this one, or finds that none has room.
     *
     * @param around what is free before it comes back
     */
    Corner corner(Note note, Corner now, double width, double height, double around) {
      double near = Notes.this.away.contains(note) ? BACK : NEAR;
      Optional<Corner> corner =
          isClear(note.own, width, height, around)
              ? Optional.of(note.own)
              : Stream.concat(Stream.of(now, note.own), Arrays.stream(Corner.values()))
                  .filter(at -> isClear(at, width, height, near))
                  .findFirst();
      corner.ifPresentOrElse(at -> taken.add(at.box(room, width, height)), () -> away.add(note));
      return corner.orElse(now);
    }

    private boolean isClear(Corner corner, double width, double height, double around) {
      Box here = corner.box(room, width, height);
      Box box = here.grown(around);
      return taken.stream().noneMatch(here::meets)
          && (drawn.filter(box::meets).isEmpty()
              || (scene.isAtHand() && scene.verticesIn(view, box, 1) == 0));
    }
  }
}
