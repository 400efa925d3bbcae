package dct.render;

import dct.core.geometry.Box;
import java.util.BitSet;
import java.util.List;

/**
 * Writes the labels of a scene beside its vertices, each where {@link LabelPlaces} finds a place
 * for it. A label for which there is no place is left out.
 *
 * <p>Vertices are served in their order, so that a picture always has the same labels; while it is
 * panned they stay where they are.
 */
final class LabelPainter {
  private static final double SIZE = 11;

  private final Scene scene;
  private final Gauge gauge;
  private final double dot;
  private final BitSet ringed; // the vertices with a ring round them
  private final LabelPlaces places;

  private LabelPainter(Scene scene, Viewport view, Box screen, Gauge gauge, double dot) {
    this.scene = scene;
    this.gauge = gauge;
    this.dot = dot;
    this.ringed = new BitSet();
    this.places = new LabelPlaces(scene, view, screen, dot, SIZE);
    for (int v : scene.unmet()) {
      ringed.set(v);
      places.take(v, gauge.ringRadius(dot));
    }
    if (!Dots.areCrowded(dot / gauge.dots())) {
      places.takeEdges();
    }
  }

  /** Writes the labels in sight of a screen that can be panned, beside dots of this radius. */
  static void paint(Scene scene, Viewport view, Box screen, double dot, Pen pen) {
    new LabelPainter(scene, view, screen, Gauge.SCREEN, dot).paint(pen);
  }

  /**
   * Writes the labels of a picture that ends at its borders: all of each is inside.
   *
   * @param taken where no label may be
   */
  static void paint(
      Scene scene, Viewport view, Box picture, Gauge gauge, double dot, List<Box> taken, Pen pen) {
    LabelPainter painter = new LabelPainter(scene, view, picture, gauge, dot);
    painter.places.keepWithin(picture);
    taken.forEach(painter.places::take);
    painter.paint(pen);
  }

  private void paint(Pen pen) {
    pen.part(Part.LABELS);
    pen.style(Stroke.fill(Ink.LABEL));
    for (int v = 0; v < scene.size(); v++) {
      double radius = ringed.get(v) ? gauge.ringRadius(dot) : dot;
      if (places.isNear(v) && places.hasRoom(v, radius)) {
        String text = scene.label(v);
        if (!text.isEmpty()) {
          places.label(v, text, radius, pen);
        }
      }
    }
  }
}
