package dct.io;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.io.format.Choice;
import dct.io.format.NoTriangulation;
import dct.io.format.RegionShape;
import dct.io.format.Regions;
import dct.io.format.SeveralShapes;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.format.plain.PlainFormat;
import dct.io.text.BadInputException;
import dct.problem.Solution;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Makes one document of the rings, holes and sites of a file, as they were chosen. */
final class ChosenRegion {
  private static final Shapes.Fault NO_RINGS =
      new Shapes.Fault(
          0, "it holds no rings that are apart, as a region has them; read it by --as points");

  private final String source;
  private final Shapes shapes;
  private final boolean yUp;
  private final Choice choice;
  private final List<String> notes = new ArrayList<>();

  private ChosenRegion(String source, Shapes shapes, boolean yUp, Choice choice) {
    this.source = source;
    this.shapes = shapes;
    this.yUp = yUp;
    this.choice = choice;
  }

  /**
   * The document: of the region that was picked, or of the only one.
   *
   * @throws SeveralShapes if there are several and nothing says which
   * @throws BadInputException if there is none, or none with the number that was picked
   */
  static PointDocument of(
      String source, Shapes shapes, boolean yUp, Choice choice, Progress progress) {
    return new ChosenRegion(source, shapes, yUp, choice).document(progress);
  }

  private PointDocument document(Progress progress) {
    RegionShape region = chosen(progress);
    Optional<PointDocument> whole =
        region.triangulated().flatMap(shape -> triangulated(region, shape, progress));
    return whole.orElseGet(
        () -> document(choice.touch().part(Regions.tidy(region, notes), notes, progress)));
  }

  private PointDocument document(RegionShape region) {
    return new PointDocument(
        source,
        Optional.of(Domain.REGION),
        Domain.REGION,
        region.points(),
        region.lines(),
        Optional.of(region.toRings()),
        Optional.empty(),
        notes,
        shapes.format().equals(PlainFormat.TITLE) && notes.isEmpty(),
        yUp,
        Optional.empty());
  }

  private RegionShape chosen(Progress progress) {
    List<Shapes.Whole> all = Regions.all(shapes, choice.touch(), progress);
    if (all.isEmpty() || all.stream().anyMatch(region -> region.shape().rings().isEmpty())) {
      Shapes.Fault fault =
          all.stream().flatMap(region -> region.fault().stream()).findFirst().orElse(NO_RINGS);
      throw new BadInputException(source, fault.line(), fault.what());
    }
    if (choice.pick().isEmpty() && all.size() > 1) {
      throw SeveralShapes.ofRegions(source, Regions.outlines(shapes, all));
    }
    Shapes.Whole region =
        choice.pick().isPresent() ? picked(all, choice.pick().getAsInt()) : all.get(0);
    notes.addAll(region.notes());
    return region.shape();
  }

  private Shapes.Whole picked(List<Shapes.Whole> all, int number) {
    int count = all.size();
    if (number < 1 || number > count) {
      String sizes =
          count == 1 ? "there is only one region" : "there are only " + count + " regions";
      throw new BadInputException(
          source, 0, sizes + ", none with the number " + number + "; pick one from 1 to " + count);
    }
    return all.get(number - 1);
  }

  /** The document with its triangulation; nothing if that is none. */
  private Optional<PointDocument> triangulated(RegionShape region, Shape shape, Progress progress) {
    try {
      Solution solution =
          new FaceReading(source, shape, shape.faces().orElseThrow(), region.rings())
              .solution(progress);
      return Optional.of(document(region).triangulated(solution));
    } catch (NoTriangulation fault) {
      notes.add(fault.note());
      return Optional.empty();
    }
  }
}
