package dct.render;

import dct.core.geometry.Box;
import dct.render.Pen.Anchor;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** What the colours and shapes of a scene stand for: those that occur in it. */
final class Legend {
  private static final double SIZE = 12;
  private static final double LEADING = 18;
  private static final double PADDING = 6;
  private static final double SAMPLE = 24; // the width of a line that is shown
  private static final double GAP = 8; // between it and its word
  private static final double ADVANCE = 0.6 * SIZE;
  private static final double DOT = 4.5;

  /** Shows how a line or a vertex is drawn. */
  private enum Shape {
    DISC,
    SQUARE,
    RING,
    LINE
  }

  /** One colour and shape, and what it stands for. */
  private record Entry(Shape shape, Stroke stroke, String word) {}

  private final List<Entry> entries = new ArrayList<>();

  private final Gauge gauge;

  Legend(Scene scene) {
    this(scene, Gauge.SCREEN);
  }

  /** A legend whose samples are drawn as the scene is with this gauge. */
  Legend(Scene scene, Gauge gauge) {
    this.gauge = gauge;
    boolean isComparison = isComparison(scene);
    addVertices(scene, isComparison ? "Parity differs" : "Unmet wish");
    List<Stroke> strokes = new ArrayList<>(scene.strokes());
    Collections.reverse(strokes);
    for (Stroke stroke : strokes) {
      boolean isCommon = isComparison && stroke.ink() == Ink.PROPOSED;
      String word = isCommon ? "In both" : word(stroke.ink(), scene.hasInside());
      if (!word.isEmpty()) {
        entries.add(new Entry(Shape.LINE, stroke, word));
      }
    }
  }

  private void addVertices(Scene scene, String ring) {
    if (scene.hasVertex(Ink.EVEN)) {
      entries.add(new Entry(Shape.DISC, Stroke.fill(Ink.EVEN), "Even degree"));
    }
    if (scene.hasVertex(Ink.ODD)) {
      entries.add(new Entry(Shape.SQUARE, Stroke.fill(Ink.ODD), "Odd degree"));
    }
    if (scene.unmet().length > 0) {
      entries.add(new Entry(Shape.RING, Stroke.solid(Ink.UNMET, 2), ring));
    }
  }

  private static boolean isComparison(Scene scene) {
    return scene.strokes().stream()
        .map(Stroke::ink)
        .anyMatch(ink -> ink == Ink.FIRST || ink == Ink.SECOND);
  }

  private static String word(Ink ink, boolean inside) {
    return switch (ink) {
      case BOUNDARY -> inside ? "Boundary" : "Hull";
      case DIAGONAL -> inside ? "Diagonal" : "Edge";
      case PARTITION -> "Partition";
      case FLIPPED -> "Flipped";
      case FIXED -> "Fixed";
      case DEFECT -> "Not simple";
      case FIRST -> "Only in A";
      case SECOND -> "Only in B";
      default -> "";
    };
  }

  boolean isEmpty() {
    return entries.isEmpty();
  }

  double width() {
    int longest = entries.stream().mapToInt(entry -> entry.word.length()).max().orElse(0);
    return SAMPLE + GAP + ADVANCE * longest + 2 * PADDING;
  }

  double height() {
    return LEADING * entries.size() + PADDING;
  }

  void paint(Pen pen, Box screen, Corner corner) {
    Box box = corner.box(Caption.room(screen), width(), height());
    Caption.ground(pen, box);
    write(pen, box, false);
  }

  /** The height of the rows that the entries fill side by side. */
  double stripHeight(double width) {
    return LEADING * rows(width).size() + PADDING;
  }

  /** Draws it without a ground, the entries below each other or side by side. */
  void write(Pen pen, Box box, boolean isStrip) {
    List<List<Entry>> rows =
        isStrip ? rows(2 * box.halfWidth()) : entries.stream().map(List::of).toList();
    double y = box.minY() + PADDING / 2 + LEADING / 2;
    for (List<Entry> row : rows) {
      double x = box.minX() + PADDING;
      for (Entry entry : row) {
        pen.style(gauge.of(entry.stroke));
        paint(pen, entry.shape, x, y);
        pen.style(Stroke.fill(Ink.LABEL));
        pen.text(x + SAMPLE + GAP, y + 0.36 * SIZE, Anchor.START, SIZE, entry.word);
        x += advance(entry);
      }
      y += LEADING;
    }
  }

  private static double advance(Entry entry) {
    return SAMPLE + GAP + ADVANCE * entry.word.length() + GAP;
  }

  private List<List<Entry>> rows(double width) {
    List<List<Entry>> rows = new ArrayList<>();
    double left = 0;
    for (Entry entry : entries) {
      if (rows.isEmpty() || advance(entry) > left) {
        rows.add(new ArrayList<>());
        left = width - 2 * PADDING + GAP;
      }
      rows.get(rows.size() - 1).add(entry);
      left -= advance(entry);
    }
    return rows;
  }

  private void paint(Pen pen, Shape shape, double x, double y) {
    double middle = x + SAMPLE / 2;
    double dot = DOT * gauge.dots();
    switch (shape) {
      case DISC -> pen.disc(middle, y, dot);
      case SQUARE -> pen.square(middle, y, Dots.SQUARE * dot);
      case RING -> pen.ring(middle, y, dot + 1);
      case LINE -> pen.line(x, y, x + SAMPLE, y);
    }
  }
}
