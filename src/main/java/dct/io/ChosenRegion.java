package dct.io;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.format.Choice;
import dct.io.format.NoTriangulation;
import dct.io.format.PointColumns;
import dct.io.format.RegionShape;
import dct.io.format.SeveralShapes;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.format.plain.PlainFormat;
import dct.io.text.BadInputException;
import dct.problem.Solution;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Makes one document of the rings, holes and sites of a file, as they were chosen. */
final class ChosenRegion {
  private final String source;
  private final Shapes shapes;
  private final boolean yUp;
  private final Choice choice;
  private final List<String> notes;

  private ChosenRegion(String source, Shapes shapes, boolean yUp, Choice choice) {
    this.source = source;
    this.shapes = shapes;
    this.yUp = yUp;
    this.choice = choice;
    this.notes = new ArrayList<>(shapes.region().map(Shapes.Whole::notes).orElse(shapes.notes()));
  }

  /** Whether a region is asked for, or the file says that it holds one. */
  static boolean isMeant(Shapes shapes, Choice choice) {
    return choice.as().map(Domain.REGION::equals).orElse(shapes.isRegion());
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
    RegionShape region = chosen();
    Optional<PointDocument> whole =
        region.triangulated().flatMap(shape -> triangulated(region, shape, progress));
    return whole.orElseGet(() -> document(parted(outerFirst(withoutRepeated(region)), progress)));
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

  private RegionShape chosen() {
    List<RegionShape> all = shapes.regions();
    if (all.isEmpty() || all.stream().anyMatch(region -> region.rings().isEmpty())) {
      throw new BadInputException(
          source,
          0,
          "it holds no rings that are apart, as a region has them; read it by --as points");
    }
    if (choice.pick().isPresent()) {
      return picked(all, choice.pick().getAsInt());
    }
    if (all.size() > 1) {
      throw SeveralShapes.ofRegions(source, shapes.outlines());
    }
    return all.get(0);
  }

  private RegionShape picked(List<RegionShape> all, int number) {
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

  private RegionShape outerFirst(RegionShape region) {
    RegionShape ordered = region.outerFirst();
    if (ordered != region) {
      int line = region.line(ordered.rings().get(0)[0]);
      notes.add("The ring at line " + line + " holds the others and is taken for the outer one");
    }
    return ordered;
  }

  /** The region with each vertex of a ring once: without those that repeat the one before. */
  private RegionShape withoutRepeated(RegionShape region) {
    Points points = region.points();
    int[] kept = new int[points.size()]; // by vertex: which one stands for it
    Arrays.setAll(kept, v -> v);
    int closed = 0;
    int repeated = 0;
    for (int[] ring : region.rings()) {
      int end = ring.length;
      if (end > 1 && same(points, ring[0], ring[end - 1])) {
        kept[ring[--end]] = ring[0];
        closed++;
      }
      for (int k = 1; k < end; k++) {
        if (same(points, ring[k - 1], ring[k])) {
          kept[ring[k]] = kept[ring[k - 1]];
          repeated++;
        }
      }
    }
    tell(closed, repeated);
    return closed + repeated == 0 ? region : without(region, kept);
  }

  private void tell(int closed, int repeated) {
    if (closed > 0) {
      notes.add(
          closed == 1
              ? "The last vertex of a ring repeats the first and is left out"
              : "The last vertices of " + closed + " rings repeat the first and are left out");
    }
    if (repeated > 0) {
      notes.add(
          repeated == 1
              ? "1 vertex repeats the one before it and is left out"
              : repeated + " vertices repeat the one before them and are left out");
    }
  }

  private static RegionShape without(RegionShape region, int[] kept) {
    int[] number = new int[kept.length];
    PointColumns columns = new PointColumns();
    for (int v = 0; v < kept.length; v++) {
      if (kept[v] == v) {
        number[v] = columns.size();
        columns.add(region.points().x(v), region.points().y(v), region.line(v));
      }
    }
    List<int[]> rings =
        region.rings().stream()
            .map(ring -> Arrays.stream(ring).filter(v -> kept[v] == v).map(v -> number[v]))
            .map(ring -> ring.toArray())
            .toList();
    int[] fixed = Arrays.stream(region.fixed()).map(v -> number[kept[v]]).toArray();
    return new RegionShape(region.label(), columns.points(), columns.lines(), rings, fixed);
  }

  private static boolean same(Points points, int u, int v) {
    return points.x(u) == points.x(v) && points.y(u) == points.y(v);
  }

  /** The region with its rings moved a hair where they meet themselves, if that is asked for. */
  private RegionShape parted(RegionShape region, Progress progress) {
    double[] x = new double[region.points().size()];
    double[] y = new double[x.length];
    Arrays.setAll(x, region.points()::x);
    Arrays.setAll(y, region.points()::y);
    for (int[] ring : region.rings()) {
      PointColumns columns = new PointColumns();
      Arrays.stream(ring).forEach(v -> columns.add(x[v], y[v], region.line(v)));
      Shape shape = Shape.of(Shape.Kind.RING, "", columns);
      Points parted = choice.touch().part(shape, notes, progress).points();
      for (int k = 0; k < ring.length; k++) {
        x[ring[k]] = parted.x(k);
        y[ring[k]] = parted.y(k);
      }
    }
    return new RegionShape(
        region.label(), Points.of(x, y), region.lines(), region.rings(), region.fixed());
  }
}
