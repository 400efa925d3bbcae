package dct.render;

import dct.core.geometry.Box;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A scene laid out as a figure; immutable.
 *
 * <p>The counts and the legend stand in corners where there is no vertex and no edge, or else in a
 * strip above the drawing; labels keep clear of both. Lengths are in units in which letters have
 * the sizes that they have on a screen in pixels.
 *
 * @param scene what is drawn, its labels those of the figure
 * @param view where
 * @param width of the sheet in units, as {@code height}
 * @param points points of a printer (1/72 inch) for each unit
 * @param pixels pixels of an image for each unit
 * @param counts where the counts are, nothing if they are not written
 * @param legend where the legend is, nothing if it is not drawn
 */
record Sheet(
    Scene scene,
    Viewport view,
    double width,
    double height,
    double points,
    double pixels,
    Gauge gauge,
    Theme theme,
    Optional<Note> counts,
    Optional<Note> legend) {
  private static final double PAPER = 0.64; // points for each unit: 11 are 7 pt
  private static final double SCREEN = 0.75; // points for each pixel, 96 of them an inch
  private static final double INCH = 72;
  private static final double MM = INCH / 25.4;
  private static final double DOTS_OF_PAPER = 300; // an inch, in an image
  private static final double THIN = 0.52; // 1.2 units are 0.4 pt
  private static final double HAIR = 0.25 / PAPER; // what printers still show, 0.25 pt
  private static final double SMALL = 0.55; // dots are 1.6 pt

  /**
   * Words or samples in a corner or strip.
   *
   * @param box where
   * @param isStrip whether it is above the drawing
   */
  record Note(Box box, boolean isStrip, Pen.Anchor anchor) {}

  /** What a part of a screen shows, one pixel for each of it. */
  static Sheet of(Scene scene, PictureView view) {
    return new Sheet(
        scene,
        view.viewport(),
        view.width(),
        view.height(),
        SCREEN,
        view.scale(),
        Gauge.SCREEN,
        Theme.LIGHT,
        Optional.empty(),
        Optional.empty());
  }

  /** An empty sheet of a figure's width. */
  static Sheet blank(Scene scene, Figure figure) {
    boolean isPaper = figure.size().unit() == Figure.Unit.MM;
    double points = isPaper ? PAPER : SCREEN;
    double width = figure.size().width() * (isPaper ? MM / PAPER : 1);
    boolean isTold = figure.theme() == Theme.PRINT;
    return new Sheet(
        scene,
        Viewport.IDENTITY,
        width,
        width,
        points,
        figure.scale() * (isPaper ? points / INCH * DOTS_OF_PAPER : 1),
        new Gauge(isPaper ? THIN : 1, isPaper ? HAIR : 0, isPaper ? SMALL : 1, isTold),
        figure.theme(),
        Optional.empty(),
        Optional.empty());
  }

  /** Whether it is for paper, or else for a screen. */
  boolean isPaper() {
    return points == PAPER;
  }

  /** All of it. */
  Box box() {
    return new Box(0, 0, width, height);
  }

  /** Whether no vertex of the scene lies beyond it. */
  boolean isWhole() {
    return scene
        .bounds()
        .map(view::screenBox)
        .filter(shown -> box().holds(shown.minX(), shown.minY()))
        .filter(shown -> box().holds(shown.maxX(), shown.maxY()))
        .isPresent();
  }

  /** The width in points of a printer. */
  double pointsWide() {
    return width * points;
  }

  /** The height in points of a printer. */
  double pointsHigh() {
    return height * points;
  }

  /** The lines of the counts, as they are written. */
  List<String> lines() {
    return Caption.folded(scene.counts(), box());
  }

  /** Draws everything but the ground. */
  void paint(Pen pen) {
    ScenePainter.paintShapes(scene, view, box(), gauge, pen);
    paintWords(pen);
  }

  /** Draws the labels and notes. */
  void paintWords(Pen pen) {
    List<Box> taken = new ArrayList<>();
    counts.ifPresent(note -> taken.add(note.box()));
    legend.ifPresent(note -> taken.add(note.box()));
    if (scene.hasLabels()) {
      double dot = ScenePainter.dotRadius(scene, view, gauge);
      LabelPainter.paint(scene, view, box(), gauge, dot, taken, pen);
    }
    pen.part(Part.COUNTS);
    counts.ifPresent(note -> Caption.write(pen, note.box(), note.anchor(), lines()));
    legend.ifPresent(note -> new Legend(scene, gauge).write(pen, note.box(), note.isStrip()));
  }
}
