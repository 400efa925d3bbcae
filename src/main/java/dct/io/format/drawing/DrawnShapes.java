package dct.io.format.drawing;

import dct.io.format.PointColumns;
import dct.io.format.RegionShape;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.text.BadInputException;
import dct.io.text.Shown;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/** The shapes of a drawing in their order, and a count of all that is left out. */
final class DrawnShapes {
  private final String file;
  private final String title;
  private final List<Drawn> shapes = new ArrayList<>();
  private final Map<String, Drawn> marks = new LinkedHashMap<>();
  private final Map<LeftOut, Integer> leftOut = new EnumMap<>(LeftOut.class);
  private final SmallMarks small = new SmallMarks();
  private final FigureRegion figure = new FigureRegion();
  private int figureShapes; // how many of the shapes are its rings
  private Optional<Drawn> background = Optional.empty();

  private record Drawn(Shape.Kind kind, Supplier<String> label, PointColumns columns) {
    Shape shape() {
      return Shape.of(kind, Shown.word(label.get()), columns);
    }
  }

  /** Nothing yet, of a file in the format with this title. */
  DrawnShapes(String file, String title) {
    this.file = file;
    this.title = title;
  }

  /** Counts what is left out. */
  void leaveOut(LeftOut what) {
    leftOut.merge(what, 1, Integer::sum);
  }

  /** Adds a ring or path; one vertex alone is nothing that can be seen. */
  void add(Supplier<String> label, Outline outline) {
    drawn(label, outline).ifPresent(shapes::add);
  }

  /** Keeps the ring that is as large as the page, for the case that there is nothing else. */
  void addBackground(Supplier<String> label, Outline outline) {
    background = drawn(label, outline);
  }

  private Optional<Drawn> drawn(Supplier<String> label, Outline outline) {
    PointColumns columns = outline.finished();
    if (columns.size() < 3) {
      if (columns.size() == 2) {
        leaveOut(LeftOut.LINE);
      }
      return Optional.empty();
    }
    Shape.Kind kind = outline.isClosed() ? Shape.Kind.RING : Shape.Kind.PATH;
    return Optional.of(new Drawn(kind, label, columns));
  }

  /** Adds a mark; all of one label are one set of sites. */
  void addMark(String label, double x, double y, int line) {
    marks
        .computeIfAbsent(
            label,
            unseen -> {
              Drawn sites = new Drawn(Shape.Kind.SITES, () -> label, new PointColumns());
              shapes.add(sites);
              return sites;
            })
        .columns
        .add(x, y, line);
  }

  /** Adds a circle or ellipse. */
  void addDisc(Supplier<String> label, double x, double y, double radius, int line) {
    small.add(label, x, y, radius, line);
    leaveOut(LeftOut.CIRCLE);
  }

  /** The figure of this program that the drawing is or holds, as far as it has been read. */
  FigureRegion figure() {
    return figure;
  }

  /** The number of rings, paths and sets of marks so far. */
  int count() {
    return shapes.size();
  }

  /** Says that all but so many shapes are the rings of a figure of this program. */
  void areOfFigure(int others) {
    for (Drawn ring : shapes.subList(others, shapes.size())) {
      figure.addRing(ring.columns);
      figureShapes++;
    }
  }

  /** Whether nothing has been drawn so far. */
  boolean isEmpty() {
    return shapes.isEmpty() && leftOut.isEmpty() && background.isEmpty();
  }

  /**
   * All shapes.
   *
   * @throws BadInputException if there are none
   */
  Shapes finished() {
    readSmallMarks();
    if (shapes.isEmpty()) {
      background.ifPresent(shapes::add);
    } else if (background.isPresent()) {
      leaveOut(LeftOut.BACKGROUND);
    }
    if (shapes.isEmpty()) {
      throw new BadInputException(file, 0, nothing());
    }
    List<String> notes = new ArrayList<>();
    leftOut.forEach((what, count) -> notes.add(what.note(count)));
    if (!figure.isEmpty() && figureShapes == shapes.size()) {
      Optional<RegionShape> region = figure.region(notes);
      if (region.isPresent()) {
        return FigureRegion.shapes(title, notes, region.get());
      }
    }
    return new Shapes(title, shapes.stream().map(Drawn::shape).toList(), notes);
  }

  /** Circles and squares are marks of sites if all are small and there is nothing else to read. */
  private void readSmallMarks() {
    List<Optional<UprightSquare>> squares =
        shapes.stream().map(drawn -> UprightSquare.of(drawn.columns.points())).toList();
    if (!leftOut.containsKey(LeftOut.CIRCLE) || squares.contains(Optional.<UprightSquare>empty())) {
      return;
    }
    for (int i = 0; i < shapes.size(); i++) {
      UprightSquare square = squares.get(i).orElseThrow();
      Drawn drawn = shapes.get(i);
      small.add(drawn.label, square.x(), square.y(), square.radius(), drawn.columns.lines()[0]);
    }
    if (small.areMarks()) {
      leftOut.remove(LeftOut.CIRCLE);
      shapes.clear();
      small.addTo(this::addMark);
    }
  }

  private String nothing() {
    String only =
        leftOut.entrySet().stream()
            .map(entry -> entry.getKey().counted(entry.getValue()))
            .collect(Collectors.joining(", "));
    return "this is "
        + title
        + " without a polygon or path of straight edges"
        + (only.isEmpty() ? "" : " (only " + only + ")")
        + "; draw one with 3 vertices or more";
  }
}
