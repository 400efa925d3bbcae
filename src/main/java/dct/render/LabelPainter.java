package dct.render;

import dct.core.geometry.Box;
import java.util.BitSet;
import java.util.List;
import java.util.function.IntToDoubleFunction;

/**
 * Writes the labels of a scene beside its vertices, each where {@link LabelPlaces} finds a place
 * for it. A label for which there is no place is left out.
 *
 * <p>Vertices are served in their order, so that a picture always has the same labels; while it is
 * panned they stay where they are.
 */
final class LabelPainter {
  private static final double SIZE = 11;

  private LabelPainter() {}

  /** Writes the labels in sight of a screen that can be panned, beside dots of this radius. */
  static void paint(Scene scene, Viewport view, Box screen, double dot, Pen pen) {
    paint(scene, new LabelPlaces(scene, view, screen, dot), Gauge.SCREEN, dot, pen);
  }

  /**
   * Writes the labels of a picture that ends at its borders: all of each is inside.
   *
   * @param taken where no label may be
   */
  static void paint(
      Scene scene, Viewport view, Box picture, Gauge gauge, double dot, List<Box> taken, Pen pen) {
    LabelPlaces places = new LabelPlaces(scene, view, picture, dot);
    places.keepWithin(picture);
    taken.forEach(places::take);
    paint(scene, places, gauge, dot, pen);
  }

  private static void paint(Scene scene, LabelPlaces places, Gauge gauge, double dot, Pen pen) {
    BitSet ringed = new BitSet();
    for (int v : scene.unmet()) {
      ringed.set(v);
      places.take(v, gauge.ringRadius(dot));
    }
    if (!Dots.areCrowded(dot / gauge.dots())) {
      places.takeEdges();
    }
    paint(scene, places, v -> ringed.get(v) ? gauge.ringRadius(dot) : dot, pen);
  }

  /**
   * Writes labels where there is place left.
   *
   * @param radius of the dot or ring at a vertex
   */
  static void paint(Scene scene, LabelPlaces places, IntToDoubleFunction radius, Pen pen) {
    pen.part(Part.LABELS);
    pen.style(Stroke.fill(Ink.LABEL));
    for (int v = 0; v < scene.size(); v++) {
      double around = radius.applyAsDouble(v);
      if (places.isNear(v) && places.hasRoom(v, around, SIZE)) {
        String text = scene.label(v);
        if (!text.isEmpty()) {
          places.label(v, text, around, SIZE, pen);
        }
      }
    }
  }
}
