package dct.io.format;

import dct.core.Progress;
import dct.core.geometry.Points;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The regions that a file holds, made tidy, and taken apart where rings touch if that is asked. */
public final class Regions {
  private final List<String> notes;

  private Regions(List<String> notes) {
    this.notes = notes;
  }

  /**
   * The regions in the order of the file, each with what was left out of it; what has triangles is
   * as it was read.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static List<Shapes.Whole> all(Shapes shapes, Touch touch, Progress progress) {
    List<Shapes.Whole> all = new ArrayList<>();
    for (RegionShape region : shapes.regions()) {
      List<String> notes =
          new ArrayList<>(shapes.region().map(Shapes.Whole::notes).orElse(shapes.notes()));
      boolean isAsRead = region.triangulated().isPresent() || region.rings().isEmpty();
      RegionShape shape = isAsRead ? region : tidy(region, notes);
      all.addAll(
          touch.split(
              new Shapes.Whole(shape, notes, shapes.region().flatMap(Shapes.Whole::fault)),
              progress));
    }
    return all;
  }

  /** The outlines of regions, for a list. */
  public static Shapes outlines(Shapes shapes, List<Shapes.Whole> regions) {
    List<Shape> outlines =
        regions.stream()
            .map(Shapes.Whole::shape)
            .filter(region -> !region.rings().isEmpty())
            .map(RegionShape::outline)
            .toList();
    return new Shapes(shapes.format(), outlines, shapes.notes());
  }

  /**
   * The region with the outermost ring first and each vertex of a ring once: without those that
   * repeat the one before.
   *
   * @param notes hears of it
   */
  public static RegionShape tidy(RegionShape region, List<String> notes) {
    Regions tidying = new Regions(notes);
    return tidying.outerFirst(tidying.withoutRepeated(region));
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
}
