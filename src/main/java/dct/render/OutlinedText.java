package dct.render;

import java.awt.Font;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import java.awt.geom.PathIterator;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;

/**
 * Text that was found in a shape: XChart fills the outlines of its letters, where a file should
 * have text.
 *
 * @param text what is written, with the spaces between words
 * @param at from the start of the baseline, which runs to the right, to where the text is; it moves
 *     and turns only
 * @param width how far the text advances
 */
public record OutlinedText(String text, AffineTransform at, double width) {
  /** How the letters are measured: smoothed, at fractions of a unit. */
  public static final FontRenderContext MEASURE = new FontRenderContext(null, true, true);

  private static final double NEAR = 0.03; // units by which points may differ: outlines are floats
  private static final int LAST = 0x2265; // the greatest character that is looked for
  private static final int LAST_OF_LATIN = 0xFF;
  private static final String OTHERS = "–—…→−≤≥"; // beyond Latin-1
  private static final int[] POINTS = {1, 1, 2, 3, 0}; // of each kind of segment

  private static final Map<Font, List<Letter>> LETTERS = new ConcurrentHashMap<>();

  /**
   * Reads the text whose letters of a font make up a shape.
   *
   * @return nothing if the shape is something else, or a letter is none of Latin-1 and a few more
   */
  public static Optional<OutlinedText> of(Shape shape, Font font) {
    Path path = Path.of(shape);
    List<Letter> letters = LETTERS.computeIfAbsent(font, OutlinedText::letters);
    return letters.stream()
        .filter(first -> path.kinds.startsWith(first.path.kinds))
        .flatMap(first -> new Reader(path, letters, first, space(font)).read().stream())
        .findFirst();
  }

  private static double space(Font font) {
    return advance(font, " ");
  }

  /** How far a text of a font advances. */
  public static double advance(Font font, String text) {
    return font.createGlyphVector(MEASURE, text).getGlyphPosition(text.length()).getX();
  }

  /** The letters of a font that can be seen, those with long outlines first. */
  private static List<Letter> letters(Font font) {
    return IntStream.rangeClosed('!', LAST)
        .filter(c -> c <= LAST_OF_LATIN || OTHERS.indexOf(c) >= 0)
        .filter(font::canDisplay)
        .mapToObj(c -> Letter.of(font, Character.toString(c)))
        .filter(letter -> letter.path.xs.length > 1)
        .sorted(Comparator.comparingInt(letter -> -letter.path.kinds.length()))
        .toList();
  }

  /** A letter with its outline, its origin at (0, 0), and how far it advances. */
  private record Letter(String text, Path path, double advance) {
    static Letter of(Font font, String text) {
      Shape outline = font.createGlyphVector(MEASURE, text).getOutline();
      return new Letter(text, Path.of(outline), OutlinedText.advance(font, text));
    }
  }

  /** The segments of a shape: a digit for each, and the points of all. */
  private static final class Path {
    private final String kinds;
    private final double[] xs;
    private final double[] ys;

    private Path(String kinds, double[] xs, double[] ys) {
      this.kinds = kinds;
      this.xs = xs;
      this.ys = ys;
    }

    static Path of(Shape shape) {
      StringBuilder kinds = new StringBuilder();
      List<Double> xs = new ArrayList<>();
      List<Double> ys = new ArrayList<>();
      double[] at = new double[6];
      for (PathIterator i = shape.getPathIterator(null); !i.isDone(); i.next()) {
        int kind = i.currentSegment(at);
        kinds.append(kind);
        for (int k = 0; k < POINTS[kind]; k++) {
          xs.add(at[2 * k]);
          ys.add(at[2 * k + 1]);
        }
      }
      return new Path(kinds.toString(), array(xs), array(ys));
    }

    private static double[] array(List<Double> values) {
      return values.stream().mapToDouble(v -> v).toArray();
    }
  }

  /** Reads a path letter by letter, along the line on which the first letter stands. */
  private static final class Reader {
    private final Path path;
    private final List<Letter> letters;
    private final double space;
    private final AffineTransform turn;
    private final StringBuilder text = new StringBuilder();
    private int segment; // the next that is not read
    private int point;
    private double pen; // where the next letter is if no space is before it

    Reader(Path path, List<Letter> letters, Letter first, double space) {
      this.path = path;
      this.letters = letters;
      this.space = space;
      this.turn = turn(first.path);
    }

    /** How the first letter must be turned and moved for its farthest points to come upon these. */
    private AffineTransform turn(Path letter) {
      double[] far =
          IntStream.range(0, letter.xs.length)
              .mapToDouble(
                  i -> Math.hypot(letter.xs[i] - letter.xs[0], letter.ys[i] - letter.ys[0]))
              .toArray();
      int end = IntStream.range(0, far.length).reduce(0, (a, b) -> far[b] > far[a] ? b : a);
      double angle =
          Math.atan2(path.ys[end] - path.ys[0], path.xs[end] - path.xs[0])
              - Math.atan2(letter.ys[end] - letter.ys[0], letter.xs[end] - letter.xs[0]);
      AffineTransform made = AffineTransform.getTranslateInstance(path.xs[0], path.ys[0]);
      made.rotate(angle);
      made.translate(-letter.xs[0], -letter.ys[0]);
      return made;
    }

    Optional<OutlinedText> read() {
      while (segment < path.kinds.length()) {
        if (letters.stream().noneMatch(this::take)) {
          return Optional.empty();
        }
      }
      return Optional.of(new OutlinedText(text.toString(), turn, pen));
    }

    /** Takes a letter if it is the next one. */
    private boolean take(Letter letter) {
      if (!path.kinds.startsWith(letter.path.kinds, segment)) {
        return false;
      }
      double start = placeOf(letter.path.xs, letter.path.ys);
      long spaces = Math.round((start - pen) / space);
      if (spaces < 0 || Math.abs(pen + spaces * space - start) > NEAR || !fits(letter, start)) {
        return false;
      }
      text.append(" ".repeat((int) spaces)).append(letter.text);
      segment += letter.path.kinds.length();
      point += letter.path.xs.length;
      pen = start + letter.advance;
      return true;
    }

    /** Where on the line the origin of an outline is whose first point is the next one. */
    private double placeOf(double[] xs, double[] ys) {
      double[] first = {xs[0], ys[0]};
      turn.deltaTransform(first, 0, first, 0, 1);
      double x = path.xs[point] - first[0] - turn.getTranslateX();
      double y = path.ys[point] - first[1] - turn.getTranslateY();
      return x * turn.getScaleX() + y * turn.getShearY();
    }

    private boolean fits(Letter letter, double start) {
      double[] at = new double[2];
      for (int i = 0; i < letter.path.xs.length; i++) {
        at[0] = letter.path.xs[i] + start;
        at[1] = letter.path.ys[i];
        turn.transform(at, 0, at, 0, 1);
        if (Math.hypot(at[0] - path.xs[point + i], at[1] - path.ys[point + i]) > NEAR) {
          return false;
        }
      }
      return true;
    }
  }
}
