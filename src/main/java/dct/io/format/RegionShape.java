package dct.io.format;

import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Rings, sites and fixed edges that a file holds, whether or not they bound a region; immutable.
 *
 * <p>Vertices are numbered in the order of the file; those on no ring are sites. The points are
 * finite, no more has been checked.
 */
public final class RegionShape {
  private final String label;
  private final Points points;
  private final int[] lines;
  private final List<int[]> rings;
  private final int[] fixed;
  private final Optional<Shape> triangulated; // the same with its triangles, if it is their rim

  /**
   * A shape; the arrays are not copied.
   *
   * @param label what lists call it; may be empty
   * @param points all vertices
   * @param lines the line of each, from 1 on
   * @param rings the vertices of each ring in order; no vertex is there twice
   * @param fixed the ends of the fixed edges, two vertices an edge
   */
  public RegionShape(String label, Points points, int[] lines, List<int[]> rings, int... fixed) {
    this(label, points, lines, rings, fixed, Optional.empty());
  }

  private RegionShape(
      String label,
      Points points,
      int[] lines,
      List<int[]> rings,
      int[] fixed,
      Optional<Shape> triangulated) {
    this.label = label;
    this.points = points;
    this.lines = lines;
    this.rings = List.copyOf(rings);
    this.fixed = fixed;
    this.triangulated = triangulated;
  }

  /** Shapes of which all that are no sites are rings. */
  public static RegionShape of(List<Shape> shapes, int... fixed) {
    PointColumns columns = new PointColumns();
    List<int[]> rings = new ArrayList<>();
    for (Shape shape : shapes) {
      int first = columns.size();
      for (int v = 0; v < shape.points().size(); v++) {
        columns.add(shape.points().x(v), shape.points().y(v), shape.line(v));
      }
      int[] ring = new int[shape.points().size()];
      Arrays.setAll(ring, k -> first + k);
      if (shape.kind() != Shape.Kind.SITES && ring.length > 0) {
        rings.add(ring);
      }
    }
    String label = shapes.isEmpty() ? "" : shapes.get(0).label();
    return new RegionShape(label, columns.points(), columns.lines(), rings, fixed);
  }

  /**
   * The regions that the shapes of a file make: one for each ring, with the holes and sites that
   * follow it. Where the file does not tell rings from holes, all its rings are of one region. The
   * rims of triangles are rings, too.
   */
  static List<RegionShape> all(List<Shape> shapes) {
    List<RegionShape> regions = new ArrayList<>();
    List<Shape> group = new ArrayList<>();
    Optional<Shape.Kind> before = Optional.empty(); // of the last ring of the group
    for (Shape shape : shapes) {
      Optional<Rim> rim = shape.faces().map(StoredFaces::rim).filter(of -> of.edges() > 0);
      if (rim.isPresent()) {
        regions.add(ofRim(shape, rim.get()));
        continue;
      }
      boolean isSites = shape.kind() == Shape.Kind.SITES;
      boolean isUntold = shape.kind() == Shape.Kind.POINTS;
      boolean follows =
          isSites
              || shape.kind() == Shape.Kind.HOLE
              || (isUntold && before.equals(Optional.of(shape.kind())));
      if (!follows && before.isPresent()) {
        add(regions, group);
        group.clear();
      }
      group.add(shape);
      before = isSites ? before : Optional.of(shape.kind());
    }
    add(regions, group);
    return regions;
  }

  private static void add(List<RegionShape> regions, List<Shape> group) {
    RegionShape region = of(group);
    if (!region.rings.isEmpty()) {
      regions.add(region);
    }
  }

  private static RegionShape ofRim(Shape shape, Rim rim) {
    RegionShape region =
        new RegionShape(
            shape.label(),
            shape.points(),
            shape.lines(),
            rim.rings(),
            new int[0],
            Optional.of(shape));
    return region.outerFirst();
  }

  /** The same with the outermost ring first. */
  public RegionShape outerFirst() {
    int outer = rings.isEmpty() ? 0 : outermost();
    if (outer == 0) {
      return this;
    }
    List<int[]> order = new ArrayList<>(rings);
    order.add(0, order.remove(outer));
    return new RegionShape(label, points, lines, order, fixed, triangulated);
  }

  /** The shape whose rim this is, with its triangles. */
  public Optional<Shape> triangulated() {
    return triangulated;
  }

  /** What lists call it; may be empty. */
  public String label() {
    return label;
  }

  /** All vertices. */
  public Points points() {
    return points;
  }

  /** The lines of all vertices, from 1 on; a copy. */
  public int[] lines() {
    return lines.clone();
  }

  /** The line of vertex v, from 1 on. */
  public int line(int v) {
    return lines[v];
  }

  /** The vertices of each ring. */
  public List<int[]> rings() {
    return rings;
  }

  /** The ends of the fixed edges; a copy. */
  public int[] fixed() {
    return fixed.clone();
  }

  /** Rings through the vertices, the first one the outer one. */
  public Rings toRings() {
    return Rings.of(points, rings, fixed);
  }

  /** The outer ring as a shape for lists, its label telling of the others. */
  public Shape outline() {
    int outer = outermost();
    PointColumns columns = new PointColumns();
    for (int v : rings.get(outer)) {
      columns.add(points.x(v), points.y(v), lines[v]);
    }
    int holes = rings.size() - 1;
    String with = holes == 0 ? "" : "with " + holes + (holes == 1 ? " hole" : " holes");
    String both = label.isEmpty() || with.isEmpty() ? label + with : label + " " + with;
    return Shape.of(Shape.Kind.RING, both, columns);
  }

  /**
   * The number of the ring that holds all others, as far as their boxes tell; 0 if the first does,
   * or none. There is a ring.
   */
  public int outermost() {
    List<Box> boxes = rings.stream().map(this::box).toList();
    int outer = 0;
    for (int r = 1; r < boxes.size(); r++) {
      outer = holds(boxes.get(r), boxes.get(outer)) ? r : outer;
    }
    int found = outer;
    boolean isRound = boxes.stream().allMatch(box -> holds(boxes.get(found), box));
    return isRound && !holds(boxes.get(0), boxes.get(outer)) ? outer : 0;
  }

  private Box box(int[] ring) {
    double[] x = Arrays.stream(ring).mapToDouble(points::x).toArray();
    double[] y = Arrays.stream(ring).mapToDouble(points::y).toArray();
    return Box.of(Points.of(x, y));
  }

  private static boolean holds(Box box, Box other) {
    return box.minX() <= other.minX()
        && box.minY() <= other.minY()
        && box.maxX() >= other.maxX()
        && box.maxY() >= other.maxY();
  }
}
