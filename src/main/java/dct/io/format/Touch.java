package dct.io.format;

import dct.core.Progress;
import dct.core.geometry.Touching;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** What is made of rings that meet themselves: nothing, unless it is asked for. */
public enum Touch {
  /** They are read as they are. */
  KEPT,
  /** They are split into the rings into which they fall apart. */
  SPLIT,
  /** Their vertices are moved a hair, so that they are simple. */
  PARTED;

  /**
   * The shapes, with the rings of a ring that is split in its place.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Shapes split(Shapes shapes, Progress progress) {
    if (this != SPLIT) {
      return shapes;
    }
    List<Shape> all = new ArrayList<>();
    List<String> notes = new ArrayList<>(shapes.notes());
    for (Shape shape : shapes.shapes()) {
      List<int[]> rings =
          shape.kind() == Shape.Kind.SITES ? List.of() : Touching.rings(shape.points(), progress);
      if (rings.size() < 2) {
        all.add(shape);
      } else {
        rings.forEach(ring -> all.add(part(shape, ring)));
        notes.add("A ring meets itself and is split into " + rings.size());
      }
    }
    return new Shapes(shapes.format(), all, notes, shapes.region(), shapes.isRegion());
  }

  private static Shape part(Shape shape, int[] ring) {
    PointColumns columns = new PointColumns();
    Arrays.stream(ring)
        .forEach(v -> columns.add(shape.points().x(v), shape.points().y(v), shape.line(v)));
    return Shape.of(shape.kind(), shape.label(), columns);
  }

  /**
   * The ring, with its vertices moved a hair where it meets itself, if that is asked for.
   *
   * @param notes hears of it
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Shape part(Shape ring, List<String> notes, Progress progress) {
    if (this != PARTED) {
      return ring;
    }
    Optional<PointColumns> parted =
        Touching.parted(ring.points(), progress)
            .filter(points -> !points.equals(ring.points()))
            .map(
                points -> {
                  PointColumns columns = new PointColumns();
                  for (int v = 0; v < points.size(); v++) {
                    columns.add(points.x(v), points.y(v), ring.line(v));
                  }
                  return columns;
                });
    parted.ifPresent(columns -> notes.add("Vertices where the ring meets itself are moved a hair"));
    return parted.map(columns -> Shape.of(ring.kind(), ring.label(), columns)).orElse(ring);
  }
}
