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

  Legend(Scene scene) {
    addVertices(scene);
    List<Stroke> strokes = new ArrayList<>(scene.strokes());
    Collections.reverse(strokes);
    for (Stroke stroke : strokes) {
      String word = word(stroke.ink(), scene.isPolygon());
      if (!word.isEmpty()) {
        entries.add(new Entry(Shape.LINE, stroke, word));
      }
    }
  }

  private void addVertices(Scene scene) {
    if (scene.hasVertex(Ink.EVEN)) {
      entries.add(new Entry(Shape.DISC, Stroke.fill(Ink.EVEN), "Even degree"));
    }
    if (scene.hasVertex(Ink.ODD)) {
      entries.add(new Entry(Shape.SQUARE, Stroke.fill(Ink.ODD), "Odd degree"));
    }
    if (scene.unmet().length > 0) {
      entries.add(new Entry(Shape.RING, Stroke.solid(Ink.UNMET, 2), "Unmet wish"));
    }
  }

  private static String word(Ink ink, boolean polygon) {
    return switch (ink) {
      case BOUNDARY -> polygon ? "Boundary" : "Hull";
      case DIAGONAL -> polygon ? "Diagonal" : "Edge";
      case PARTITION -> "Partition";
      case FLIPPED -> "Flipped";
      case DEFECT -> "Not simple";
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
    double x = box.minX() + PADDING;
    double y = box.minY() + PADDING / 2 + LEADING / 2;
    for (Entry entry : entries) {
      pen.style(entry.stroke);
      paint(pen, entry.shape, x, y);
      pen.style(Stroke.fill(Ink.LABEL));
      pen.text(x + SAMPLE + GAP, y + 0.36 * SIZE, Anchor.START, SIZE, entry.word);
      y += LEADING;
    }
  }

  private static void paint(Pen pen, Shape shape, double x, double y) {
    double middle = x + SAMPLE / 2;
    switch (shape) {
      case DISC -> pen.disc(middle, y, DOT);
      case SQUARE -> pen.square(middle, y, Dots.SQUARE * DOT);
      case RING -> pen.ring(middle, y, DOT + 1);
      case LINE -> pen.line(x, y, x + SAMPLE, y);
    }
  }
}
