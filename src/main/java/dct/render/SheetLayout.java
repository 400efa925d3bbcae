package dct.render;

import dct.core.geometry.Box;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Lays a scene out as a figure: the size of the sheet, where the drawing is, and where the notes.
 */
final class SheetLayout {
  private static final double CANVAS = 0.7; // the height of a figure that is not cropped, of width
  private static final double TALLEST = 2.5; // the largest height of one that is
  private static final double MARGIN = 3; // units beside what is drawn
  private static final double AROUND = 5; // units that are free round a note
  private static final double LETTER = 6.8; // the width of one in a label
  private static final double LINE = 15; // the height of a label and what parts it from its dot
  private static final double LONGEST = 12; // letters of a label that room is kept for
  private static final double EMPTY = 40; // the height of a picture without vertices

  private final Scene scene;
  private final Figure figure;
  private final Sheet blank;
  private final double marginX;
  private final double marginY;

  private double width;
  private double height;
  private double strip;
  private Viewport view;

  private SheetLayout(Scene scene, Figure figure) {
    this.scene = scene;
    this.figure = figure;
    this.blank = Sheet.blank(scene, figure);
    double dot = 4.5 * blank.gauge().dots();
    double ring = scene.unmet().length > 0 ? blank.gauge().ringRadius(dot) : dot;
    double mark = scene.defects().isEmpty() ? ring : Math.max(ring, 10 * blank.gauge().dots());
    boolean labels = scene.hasLabels();
    this.marginX = MARGIN + mark + (labels ? LETTER * longestLabel() : 0);
    this.marginY = MARGIN + mark + (labels ? LINE : 0);
  }

  /** Lays a scene out in linear time, with sorting it if that has not been done. */
  static Sheet of(Scene scene, Figure figure) {
    return new SheetLayout(scene.withLabels(figure.labels()), figure).sheet();
  }

  private double longestLabel() {
    int longest = 0;
    for (int v = 0; v < scene.size() && longest < LONGEST; v++) {
      longest = Math.max(longest, scene.label(v).length());
    }
    return Math.min(LONGEST, longest);
  }

  private Sheet sheet() {
    boolean hasCounts = figure.counts() && !scene.counts().isEmpty();
    boolean hasLegend = figure.legend() && !new Legend(scene, blank.gauge()).isEmpty();
    Notes notes = notes(hasCounts, hasLegend);
    return new Sheet(
        scene,
        view,
        width,
        height,
        blank.points(),
        blank.pixels(),
        blank.gauge(),
        blank.theme(),
        notes.counts,
        notes.legend);
  }

  /** Where the notes are. */
  private record Notes(Optional<Sheet.Note> counts, Optional<Sheet.Note> legend) {}

  /** Places the drawing and the notes: those that have no corner in a strip. */
  private Notes notes(boolean hasCounts, boolean hasLegend) {
    boolean countsInStrip = false;
    boolean legendInStrip = false;
    while (true) {
      place(countsInStrip, legendInStrip, hasCounts || hasLegend);
      List<Sheet.Note> taken = new ArrayList<>();
      Optional<Sheet.Note> counts =
          countsInStrip
              ? Optional.of(countsStrip())
              : hasCounts ? corner(Corner.UPPER_RIGHT, countsSize(), taken) : Optional.empty();
      counts.ifPresent(taken::add);
      Optional<Sheet.Note> legend =
          legendInStrip
              ? Optional.of(legendStrip(countsInStrip))
              : hasLegend ? corner(Corner.LOWER_LEFT, legendSize(), taken) : Optional.empty();
      if (counts.isPresent() == hasCounts && legend.isPresent() == hasLegend) {
        return new Notes(counts, legend);
      }
      countsInStrip |= hasCounts && counts.isEmpty();
      legendInStrip |= hasLegend && legend.isEmpty();
    }
  }

  private void place(boolean countsInStrip, boolean legendInStrip, boolean hasNotes) {
    width = blank.width();
    strip = countsInStrip ? countsSize()[1] : 0;
    strip += legendInStrip ? new Legend(scene, blank.gauge()).stripHeight(width) : 0;
    height = (figure.isCropped() ? croppedHeight() : CANVAS * width - strip) + strip;
    if (scene.bounds().isEmpty()) {
      view = Viewport.IDENTITY;
      return;
    }
    Box box = scene.bounds().get();
    double top = strip > 0 ? strip + MARGIN - marginY / 2 : 0;
    double roomX = width - 2 * marginX;
    double roomY = height - strip - 2 * marginY;
    if (figure.isCropped() && !hasNotes && box.halfWidth() * roomY < box.halfHeight() * roomX) {
      width = 2 * marginX + roomY * (box.halfWidth() / box.halfHeight());
      roomX = width - 2 * marginX;
    }
    height += Math.max(0, top - strip);
    view =
        Viewport.fit(box, Math.max(roomX, 2), Math.max(roomY, 2), 0, figure.yUp())
            .panned(marginX, marginY + Math.max(strip, top));
  }

  private double croppedHeight() {
    if (scene.bounds().isEmpty()) {
      return EMPTY;
    }
    Box box = scene.bounds().get();
    double room = width - 2 * marginX;
    double high = box.halfHeight() == 0 ? 0 : room * (box.halfHeight() / box.halfWidth());
    return Math.min(TALLEST * width, high + 2 * marginY);
  }

  private double[] countsSize() {
    List<String> lines = Caption.folded(scene.counts(), new Box(0, 0, width, 1));
    return new double[] {Math.min(width, Caption.width(lines)), Caption.height(lines.size())};
  }

  private double[] legendSize() {
    Legend legend = new Legend(scene, blank.gauge());
    return new double[] {legend.width(), legend.height()};
  }

  private Sheet.Note countsStrip() {
    double[] size = countsSize();
    return new Sheet.Note(new Box(0, 0, width, size[1]), true, Pen.Anchor.START);
  }

  private Sheet.Note legendStrip(boolean belowCounts) {
    double top = belowCounts ? countsSize()[1] : 0;
    return new Sheet.Note(new Box(0, top, width, strip), true, Pen.Anchor.START);
  }

  /** A corner where a note of this size covers nothing, its own one rather than another. */
  private Optional<Sheet.Note> corner(Corner own, double[] size, List<Sheet.Note> taken) {
    Box room = new Box(0, strip, width, height);
    return Stream.concat(Stream.of(own), Arrays.stream(Corner.values()))
        .map(at -> new Sheet.Note(at.box(room, size[0], size[1]), false, at.anchor()))
        .filter(note -> room.holds(note.box().minX(), note.box().minY()))
        .filter(note -> room.holds(note.box().maxX(), note.box().maxY()))
        .filter(note -> taken.stream().noneMatch(other -> other.box().meets(note.box())))
        .filter(note -> isClear(note.box().grown(AROUND)))
        .findFirst();
  }

  private boolean isClear(Box box) {
    if (scene.bounds().isEmpty() || !view.screenBox(scene.bounds().get()).meets(box)) {
      return true;
    }
    return scene.verticesIn(view, box, 1) == 0 && !hasEdge(box);
  }

  private boolean hasEdge(Box box) {
    double across = Math.hypot(box.halfWidth(), box.halfHeight());
    Rectangle2D.Double part =
        new Rectangle2D.Double(box.minX(), box.minY(), 2 * box.halfWidth(), 2 * box.halfHeight());
    boolean[] found = new boolean[1];
    scene.visitNear(
        view,
        box.centerX(),
        box.centerY(),
        (u, v) -> {
          found[0] =
              found[0]
                  || part.intersectsLine(
                      view.screenX(scene.x(u)),
                      view.screenY(scene.y(u)),
                      view.screenX(scene.x(v)),
                      view.screenY(scene.y(v)));
          return across;
        });
    return found[0];
  }
}
