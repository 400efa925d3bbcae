package dct.render;

import dct.core.degree.Mark;
import dct.core.degree.Mark.Tone;
import dct.core.geometry.Box;
import dct.render.Pen.Anchor;
import java.util.BitSet;
import java.util.List;

/**
 * Draws marks over a scene, so that what is below them can still be seen: areas as hatches inside
 * their boundary, vertices as rings with a label where there is room for it. Linear in the number
 * of marks, and with labels of vertices and edges in sight.
 */
public final class MarkPainter {
  private static final double INSET = 0.88; // of an area, from its centre
  private static final double HATCH = 7; // pixels from line to line
  private static final double RING_GAP = 4.5;
  private static final double SIZE = 13;
  private static final double CROWDED = 1.6; // labels are left out where dots are smaller
  private static final double REACH = 40; // how far a ring or label reaches from its vertex
  private static final int MOST_HATCHES = 400; // of one area

  private final Scene scene;
  private final Viewport view;
  private final Box screen;
  private final Pen pen;
  private final double dot;

  private MarkPainter(Scene scene, Viewport view, Box screen, Pen pen) {
    this.scene = scene;
    this.view = view;
    this.screen = screen;
    this.pen = pen;
    dot = ScenePainter.dotRadius(scene, view);
  }

  /**
   * Draws marks, each over those before it, and writes the labels of vertices in sight: those of
   * the marks first, and those of the scene where there is room left.
   *
   * @param scene what they are drawn over; it has the vertices that they name
   * @param screen the part of the screen to draw on, in pixels
   */
  public static void paint(List<Mark> marks, Scene scene, Viewport view, Box screen, Pen pen) {
    MarkPainter painter = new MarkPainter(scene, view, screen.grown(REACH), pen);
    for (Mark mark : marks) {
      painter.paint(mark);
    }
    if (!marks.isEmpty() && scene.isAtHand()) {
      painter.labels(marks, screen);
    }
  }

  private void paint(Mark mark) {
    if (mark instanceof Mark.Vertex vertex) {
      vertex(vertex);
    } else if (mark instanceof Mark.Segment segment) {
      pen.style(Stroke.solid(ink(segment.tone()), segment.tone() == Tone.WHITE ? 2.5 : 4.5));
      pen.line(x(segment.from()), y(segment.from()), x(segment.to()), y(segment.to()));
    } else if (mark instanceof Mark.Area area) {
      area(area);
    } else if (mark instanceof Mark.Band band) {
      band(band);
    }
  }

  /** The colour of a tone. */
  static Ink ink(Tone tone) {
    return switch (tone) {
      case ONE -> Ink.MARK_ONE;
      case TWO -> Ink.MARK_TWO;
      case THREE -> Ink.MARK_THREE;
      case BLACK -> Ink.LABEL;
      case WHITE -> Ink.PROPOSED;
      case MAIN -> Ink.HIGHLIGHT;
      case FAULT -> Ink.DEFECT;
    };
  }

  private double x(int v) {
    return view.screenX(scene.x(v));
  }

  private double y(int v) {
    return view.screenY(scene.y(v));
  }

  private void vertex(Mark.Vertex mark) {
    double x = x(mark.vertex());
    double y = y(mark.vertex());
    if (screen.holds(x, y)) {
      pen.style(Stroke.solid(ink(mark.tone()), isCrowded() ? 1.5 : 2.5));
      pen.ring(x, y, ringRadius());
    }
  }

  private boolean isCrowded() {
    return dot < CROWDED;
  }

  private double ringRadius() {
    return isCrowded() ? dot + 1.5 : dot + RING_GAP;
  }

  /** Writes the labels of the marked vertices, and then those of the scene. */
  private void labels(List<Mark> marks, Box inSight) {
    BitSet ringed = new BitSet();
    LabelPlaces places = new LabelPlaces(scene, view, inSight, dot);
    for (int v : scene.unmet()) {
      ringed.set(v);
    }
    for (Mark mark : marks) {
      if (mark instanceof Mark.Vertex vertex) {
        ringed.set(vertex.vertex());
      }
    }
    ringed.stream().forEach(v -> places.take(v, ringRadius()));
    if (!isCrowded()) {
      places.takeEdges();
      marks.forEach(mark -> label(mark, places));
    }
    if (scene.hasLabels()) {
      LabelPainter.paint(scene, places, v -> ringed.get(v) ? ringRadius() : dot, pen);
    }
  }

  private void label(Mark mark, LabelPlaces places) {
    if (mark instanceof Mark.Vertex vertex
        && !vertex.label().isEmpty()
        && places.isNear(vertex.vertex())) {
      pen.style(Stroke.fill(ink(vertex.tone())));
      places.label(vertex.vertex(), vertex.label(), ringRadius(), SIZE, pen);
    }
  }

  /** A boundary a little inside the area's, and but for white a hatch in it. */
  private void area(Mark.Area mark) {
    int n = mark.corners().size();
    double[] xs = new double[n];
    double[] ys = new double[n];
    double centreX = mark.corners().stream().mapToDouble(this::x).average().orElseThrow();
    double centreY = mark.corners().stream().mapToDouble(this::y).average().orElseThrow();
    for (int k = 0; k < n; k++) {
      xs[k] = centreX + INSET * (x(mark.corners().get(k)) - centreX);
      ys[k] = centreY + INSET * (y(mark.corners().get(k)) - centreY);
    }
    pen.style(Stroke.solid(ink(mark.tone()), 1.5));
    for (int k = 0; k < n; k++) {
      int next = (k + 1) % n;
      pen.line(xs[k], ys[k], xs[next], ys[next]);
    }
    if (mark.tone() != Tone.WHITE) {
      pen.style(Stroke.solid(ink(mark.tone()), 1));
      hatch(xs, ys);
    }
  }

  /** Lines that rise to the right, as far as they are inside a convex polygon and on the screen. */
  private void hatch(double[] xs, double[] ys) {
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (int k = 0; k < xs.length; k++) {
      low = Math.min(low, xs[k] + ys[k]);
      high = Math.max(high, xs[k] + ys[k]);
    }
    low = Math.max(low, screen.minX() + screen.minY());
    high = Math.min(high, screen.maxX() + screen.maxY());
    double step = Math.max(HATCH, (high - low) / MOST_HATCHES);
    for (double sum = Math.ceil(low / step) * step; sum < high; sum += step) {
      hatch(xs, ys, sum);
    }
  }

  /** The part of the line x + y = sum inside a convex polygon. */
  private void hatch(double[] xs, double[] ys, double sum) {
    double left = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    for (int k = 0; k < xs.length; k++) {
      int next = (k + 1) % xs.length;
      double here = xs[k] + ys[k] - sum;
      double there = xs[next] + ys[next] - sum;
      if (here * there < 0) {
        double at = xs[k] + (xs[next] - xs[k]) * here / (here - there);
        left = Math.min(left, at);
        right = Math.max(right, at);
      }
    }
    if (left < right) {
      pen.line(left, sum - left, right, sum - right);
    }
  }

  /** The outline of a rectangle, kept on the screen so that its label can be read. */
  private void band(Mark.Band band) {
    double x1 = clampX(Math.min(view.screenX(band.left()), view.screenX(band.right())) - HATCH);
    double x2 = clampX(Math.max(view.screenX(band.left()), view.screenX(band.right())) + HATCH);
    double y1 = clampY(Math.min(view.screenY(band.low()), view.screenY(band.high())) - HATCH);
    double y2 = clampY(Math.max(view.screenY(band.low()), view.screenY(band.high())) + HATCH);
    pen.style(Stroke.dashed(ink(band.tone()), 2));
    pen.line(x1, y1, x2, y1);
    pen.line(x2, y1, x2, y2);
    pen.line(x2, y2, x1, y2);
    pen.line(x1, y2, x1, y1);
    pen.text((x1 + x2) / 2, y1 - 4, Anchor.MIDDLE, SIZE + 2, band.label());
  }

  private double clampX(double x) {
    return Math.max(screen.minX(), Math.min(screen.maxX(), x));
  }

  private double clampY(double y) {
    return Math.max(screen.minY(), Math.min(screen.maxY(), y));
  }
}
