package dct.io.format.drawing;

import dct.core.geometry.Points;
import dct.io.format.PointColumns;
import dct.io.format.RegionShape;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The rings, marks and fixed edges of a figure that this program drew, put together as the polygon
 * or region that they show: marks at no vertex of a ring are sites, and fixed edges join the
 * vertices nearest to their ends.
 *
 * <p>Places are compared on the page, where they are rounded. Linear expected time.
 */
final class FigureRegion {
  private static final double NEAR = 0.02; // of a place on the page; two digits are written
  private static final double CELL = 0.05;

  private final List<PointColumns> rings = new ArrayList<>();
  private final PointColumns marks = new PointColumns();
  private final List<double[]> fixed = new ArrayList<>(); // both ends, on the page
  private final Map<Long, List<Integer>> cells = new HashMap<>(); // vertices, by place on the page
  private Affine toPage = Affine.IDENTITY;

  /** Says how its points are mapped to the page, if not as they are. */
  void mapBy(Affine map) {
    toPage = map;
  }

  /** Whether no ring has been added. */
  boolean isEmpty() {
    return rings.isEmpty();
  }

  void addRing(PointColumns ring) {
    rings.add(ring);
  }

  void addMark(double x, double y, int line) {
    marks.add(x, y, line);
  }

  /** Adds a fixed edge by its ends on the page. */
  void addFixed(double... ends) {
    fixed.add(ends);
  }

  /**
   * The figure as a region, if it is more than one ring.
   *
   * @param notes hears of what is left out
   */
  Optional<RegionShape> region(List<String> notes) {
    PointColumns all = new PointColumns();
    List<int[]> numbers = new ArrayList<>();
    for (PointColumns ring : rings) {
      Points corners = ring.points();
      int[] lines = ring.lines();
      int[] vertices = new int[lines.length];
      Arrays.setAll(vertices, k -> add(all, corners, k, lines[k]));
      numbers.add(vertices);
    }
    addSites(all, notes);
    int[] ends = fixedEnds(all.points(), notes);
    boolean isRing = numbers.size() == 1 && all.size() == numbers.get(0).length && ends.length == 0;
    return isRing
        ? Optional.empty()
        : Optional.of(new RegionShape("", all.points(), all.lines(), numbers, ends));
  }

  /** Adds the marks that are no vertices of rings, unless the rings have been moved since. */
  private void addSites(PointColumns all, List<String> notes) {
    Points places = marks.points();
    Points onRings = all.points();
    BitSet isMarked = new BitSet();
    BitSet isSite = new BitSet();
    isSite.set(0, places.size());
    for (double within : new double[] {0, NEAR}) { // first those exactly at a vertex
      for (int m = isSite.nextSetBit(0); m >= 0; m = isSite.nextSetBit(m + 1)) {
        int v = nearest(onRings, isMarked, pageX(places, m), pageY(places, m), within);
        if (v >= 0) {
          isMarked.set(v);
          isSite.clear(m);
        }
      }
    }
    int[] sites = isSite.stream().toArray();
    if (sites.length > Math.max(0, places.size() - onRings.size())) {
      int count = sites.length;
      notes.add(
          count
              + (count == 1 ? " mark that is" : " marks that are")
              + " at no vertex of a ring left out");
      return;
    }
    int[] lines = marks.lines();
    Arrays.stream(sites).forEach(m -> add(all, places, m, lines[m]));
  }

  private int[] fixedEnds(Points points, List<String> notes) {
    List<Integer> ends = new ArrayList<>();
    BitSet none = new BitSet();
    int lost = 0;
    for (double[] edge : fixed) {
      int u = nearest(points, none, edge[0], edge[1], NEAR);
      int v = nearest(points, none, edge[2], edge[3], NEAR);
      if (u >= 0 && v >= 0 && u != v) {
        ends.addAll(List.of(u, v));
      } else {
        lost++;
      }
    }
    if (lost > 0) {
      notes.add(
          lost + (lost == 1 ? " fixed edge" : " fixed edges") + " between no vertices left out");
    }
    return ends.stream().mapToInt(v -> v).toArray();
  }

  private int add(PointColumns all, Points points, int k, int line) {
    int v = all.size();
    all.add(points.x(k), points.y(k), line);
    cells
        .computeIfAbsent(cell(pageX(points, k), pageY(points, k), 0, 0), none -> new ArrayList<>())
        .add(v);
    return v;
  }

  private double pageX(Points points, int k) {
    return toPage.x(points.x(k), points.y(k));
  }

  private double pageY(Points points, int k) {
    return toPage.y(points.x(k), points.y(k));
  }

  private static long cell(double x, double y, int right, int up) {
    long column = Math.round(x / CELL) + right;
    long row = Math.round(y / CELL) + up;
    return (column << 32) ^ (row & 0xFFFFFFFFL);
  }

  /** The vertex nearest to a place of the page, but for some, or a negative number if none is. */
  private int nearest(Points points, BitSet except, double x, double y, double within) {
    int best = Points.NONE;
    double least = Math.nextUp(within);
    for (int right = -1; right <= 1; right++) {
      for (int up = -1; up <= 1; up++) {
        for (int v : cells.getOrDefault(cell(x, y, right, up), List.of())) {
          double far = Math.max(Math.abs(pageX(points, v) - x), Math.abs(pageY(points, v) - y));
          if (far < least && !except.get(v)) {
            least = far;
            best = v;
          }
        }
      }
    }
    return best;
  }

  /**
   * What a drawing holds that is this figure.
   *
   * @param title of the format
   * @param notes what was left out
   * @param region what it shows
   */
  static Shapes shapes(String title, List<String> notes, RegionShape region) {
    List<Shape> shapes = new ArrayList<>();
    boolean[] isOnRing = new boolean[region.points().size()];
    for (int[] ring : region.rings()) {
      PointColumns columns = new PointColumns();
      for (int v : ring) {
        columns.add(region.points().x(v), region.points().y(v), region.line(v));
        isOnRing[v] = true;
      }
      shapes.add(Shape.of(shapes.isEmpty() ? Shape.Kind.RING : Shape.Kind.HOLE, "", columns));
    }
    PointColumns sites = new PointColumns();
    for (int v = 0; v < isOnRing.length; v++) {
      if (!isOnRing[v]) {
        sites.add(region.points().x(v), region.points().y(v), region.line(v));
      }
    }
    if (sites.size() > 0) {
      shapes.add(Shape.of(Shape.Kind.SITES, "", sites));
    }
    return new Shapes(title, shapes, notes, Optional.of(new Shapes.Whole(region, notes)), true);
  }
}
