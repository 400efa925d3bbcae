package dct.io;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.format.Choice;
import dct.io.format.NoTriangulation;
import dct.io.format.PointColumns;
import dct.io.format.SeveralShapes;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.format.StoredFaces;
import dct.io.format.plain.PlainFormat;
import dct.io.text.BadInputException;
import dct.problem.Solution;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Makes one document of the shapes of a file, as they were chosen. */
final class ChosenShape {
  private final String source;
  private final Shapes shapes;
  private final boolean yUp;
  private final Choice choice;
  private final List<String> notes;

  private ChosenShape(String source, Shapes shapes, boolean yUp, Choice choice) {
    this.source = source;
    this.shapes = shapes;
    this.yUp = yUp;
    this.choice = choice;
    this.notes = new ArrayList<>(shapes.notes());
  }

  /**
   * The document: of the shape that was picked, of the only one, or of all points if they are to be
   * sites.
   *
   * @param yUp whether y grows upwards in such a file
   * @throws NoTriangulation if it holds triangles that are no triangulation of its points, and
   *     nothing says what the points are
   * @throws SeveralShapes if there are several and nothing says which
   * @throws BadInputException if there is none with the number that was picked
   */
  static PointDocument of(
      String source, Shapes shapes, boolean yUp, Choice choice, Progress progress) {
    if (shapes.areRegion(choice.as())) {
      return ChosenRegion.of(source, shapes, yUp, choice, progress);
    }
    Shapes apart = choice.touch().split(shapes, progress);
    return new ChosenShape(source, apart, yUp, choice).document(progress);
  }

  private PointDocument document(Progress progress) {
    Shape shape = shape();
    Optional<Domain> domain = choice.as().or(shape::domain);
    Domain is = domain.orElse(choice.otherwise());
    if (shape.faces().isPresent()) {
      Optional<PointDocument> whole = triangulated(shape, shape.faces().get(), is, progress);
      if (whole.isPresent()) {
        return whole.get();
      }
    }
    if (is == Domain.SITES) {
      return document(shape, domain);
    }
    return document(choice.touch().part(withoutRepeated(shape), notes, progress), domain);
  }

  /** The document with its triangulation; nothing if that is none and the points are asked for. */
  private Optional<PointDocument> triangulated(
      Shape shape, StoredFaces faces, Domain is, Progress progress) {
    FaceReading reading = new FaceReading(source, shape, faces, is);
    try {
      Solution solution = reading.solution(progress);
      return Optional.of(document(reading.shape(), Optional.of(is)).triangulated(solution));
    } catch (NoTriangulation fault) {
      if (choice.as().isEmpty()) {
        throw fault;
      }
      notes.add(fault.note());
      return Optional.empty();
    }
  }

  private PointDocument document(Shape kept, Optional<Domain> domain) {
    return new PointDocument(
        source,
        domain,
        choice.otherwise(),
        kept.points(),
        kept.lines(),
        Optional.empty(),
        Optional.empty(),
        notes,
        isOwn(),
        yUp,
        Optional.empty());
  }

  private boolean isOwn() {
    return shapes.format().equals(PlainFormat.TITLE)
        && shapes.shapes().size() == 1
        && notes.isEmpty();
  }

  private Shape shape() {
    List<Shape> all = shapes.shapes();
    if (choice.pick().isPresent()) {
      return picked(choice.pick().getAsInt());
    }
    if (all.size() == 1) {
      return all.get(0);
    }
    if (choice.as().equals(Optional.of(Domain.SITES)) && haveSamePoints(all)) {
      notes.add("Only the points are read, and none of their " + all.size() + " triangulations");
      return all.get(0).withoutFaces();
    }
    boolean areTriangulated = all.stream().anyMatch(shape -> shape.faces().isPresent());
    boolean areSites =
        !areTriangulated && all.stream().allMatch(shape -> shape.kind() == Shape.Kind.SITES);
    if (areSites || choice.as().equals(Optional.of(Domain.SITES))) {
      return joined(all);
    }
    throw new SeveralShapes(source, shapes);
  }

  private Shape picked(int number) {
    int count = shapes.shapes().size();
    if (number < 1 || number > count) {
      String sizes = count == 1 ? "there is only one shape" : "there are only " + count + " shapes";
      throw new BadInputException(
          source, 0, sizes + ", none with the number " + number + "; pick one from 1 to " + count);
    }
    return shapes.shapes().get(number - 1);
  }

  private static boolean haveSamePoints(List<Shape> all) {
    return all.stream().allMatch(shape -> shape.points().equals(all.get(0).points()));
  }

  private static Shape joined(List<Shape> all) {
    PointColumns columns = new PointColumns();
    for (Shape shape : all) {
      for (int v = 0; v < shape.points().size(); v++) {
        columns.add(shape.points().x(v), shape.points().y(v), shape.line(v));
      }
    }
    return Shape.of(Shape.Kind.SITES, "", columns);
  }

  /** The ring with each vertex once: without those that repeat the one before or, last, v0. */
  private Shape withoutRepeated(Shape shape) {
    Points points = shape.points();
    PointColumns columns = new PointColumns();
    int last = points.size() - 1;
    boolean closed = last > 0 && same(points, 0, last);
    int end = closed ? last : last + 1;
    for (int v = 0; v < end; v++) {
      if (v == 0 || !same(points, v - 1, v)) {
        columns.add(points.x(v), points.y(v), shape.line(v));
      }
    }
    int repeated = end - columns.size();
    if (repeated == 0 && !closed) {
      return shape;
    }
    if (closed) {
      notes.add("The last vertex repeats the first and is left out");
    }
    if (repeated > 0) {
      notes.add(
          repeated == 1
              ? "1 vertex repeats the one before it and is left out"
              : repeated + " vertices repeat the one before them and are left out");
    }
    return Shape.of(shape.kind(), shape.label(), columns);
  }

  private static boolean same(Points points, int u, int v) {
    return points.x(u) == points.x(v) && points.y(u) == points.y(v);
  }
}
