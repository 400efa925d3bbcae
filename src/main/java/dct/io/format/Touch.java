package dct.io.format;

import dct.core.Progress;
import dct.core.geometry.Piece;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.geometry.Touching;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** What is made of rings that meet themselves or each other: nothing, unless it is asked for. */
public enum Touch {
  /** They are read as they are. */
  KEPT,
  /** They are taken apart where they touch. */
  SPLIT,
  /** Their vertices are moved a hair, so that nothing touches. */
  PARTED;

  private static final String MOVED = " are moved a hair";

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
          shape.kind() == Shape.Kind.SITES || shape.faces().isPresent()
              ? List.of()
              : Touching.rings(shape.points(), progress);
      if (rings.isEmpty() || (rings.size() == 1 && isAll(rings.get(0), shape.points()))) {
        all.add(shape);
      } else {
        rings.forEach(ring -> all.add(part(shape, ring)));
        notes.add(
            rings.size() == 1
                ? "What a ring goes to and fro only is left out"
                : "A ring meets itself and is split into " + rings.size());
      }
    }
    return new Shapes(shapes.format(), all, notes, shapes.region(), shapes.isRegion());
  }

  /** Whether only vertices that repeat those before them are missing in a ring. */
  private static boolean isAll(int[] ring, Points points) {
    int n = points.size();
    int different = 0;
    for (int v = 0; v < n; v++) {
      different += points.same(v, v + 1 == n ? 0 : v + 1) ? 0 : 1;
    }
    return ring.length == different;
  }

  private static Shape part(Shape shape, int... ring) {
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
    Optional<Points> parted =
        Touching.parted(ring.points(), progress).filter(points -> !points.equals(ring.points()));
    parted.ifPresent(points -> notes.add("Vertices where the ring meets itself" + MOVED));
    return parted
        .map(points -> new Shape(ring.kind(), ring.label(), points, ring.lines(), Optional.empty()))
        .orElse(ring);
  }

  /**
   * The parts of a region that hang together, if that is asked for and there are several, or its
   * rings join to others; also if a hair is asked for, but parts them on their own only. Otherwise
   * the region alone.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  List<Shapes.Whole> split(Shapes.Whole region, Progress progress) {
    RegionShape shape = region.shape();
    if (this == KEPT || shape.triangulated().isPresent() || shape.rings().isEmpty()) {
      return List.of(region);
    }
    Rings rings = shape.toRings();
    boolean isParted = this == PARTED && Touching.parted(rings, progress).isPresent();
    Optional<List<Piece>> pieces = isParted ? Optional.empty() : Touching.pieces(rings, progress);
    boolean isJoined = this == SPLIT && pieces.filter(all -> !all.get(0).isPinched()).isPresent();
    if (pieces.filter(all -> all.size() > 1 || isJoined).isEmpty()) {
      return List.of(region);
    }
    List<String> notes = new ArrayList<>(region.notes());
    int count = pieces.get().size();
    notes.add(
        count == 1
            ? "Rings touch and are joined"
            : "Rings touch, and the region is split into " + count);
    return pieces.get().stream().map(piece -> new Shapes.Whole(part(shape, piece), notes)).toList();
  }

  private static RegionShape part(RegionShape shape, Piece piece) {
    PointColumns columns = new PointColumns();
    for (int v : piece.vertices()) {
      columns.add(shape.points().x(v), shape.points().y(v), shape.line(v));
    }
    return new RegionShape(
        shape.label(), columns.points(), columns.lines(), piece.rings(), piece.fixed());
  }

  /**
   * The region, with its vertices moved a hair where rings meet, if that is asked for.
   *
   * @param notes hears of it
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public RegionShape part(RegionShape region, List<String> notes, Progress progress) {
    Optional<Rings> parted =
        this == PARTED ? Touching.parted(region.toRings(), progress) : Optional.empty();
    if (parted.filter(rings -> !rings.points().equals(region.points())).isEmpty()) {
      return region;
    }
    notes.add("Vertices where rings meet" + MOVED);
    Rings rings = parted.get();
    return new RegionShape(
        region.label(), rings.points(), region.lines(), region.rings(), rings.fixed());
  }
}
