package dct.core.geometry;

import dct.core.Progress;
import java.util.Arrays;

/**
 * The inside of an outer ring without the holes in it, with sites and fixed edges inside: checked
 * once, here. A simple polygon is one without holes, sites and fixed edges.
 *
 * <p>Vertices keep the numbers in which they were entered. Inside, each ring is walked with the
 * region on its left: the outer one counter-clockwise, holes clockwise. A <em>position</em>, 0 … m
 * − 1, is a place on these walks, one after the other; m vertices are on rings, the others are
 * sites.
 *
 * <p>Every triangulation of n ring vertices, k holes and i sites has 2i + n + 2k − 2 triangles.
 */
public final class Region {
  private final Points points;
  private final SimplePolygon polygon; // null if it is none
  private final Rings rings;
  private final int[] walk; // by position: the vertex; null for a polygon, as the next three are
  private final int[] positions; // by vertex: its position, or NONE
  private final int[] after; // by position: the next one on its walk
  private final int[] before; // by position: the one before it

  private Region(SimplePolygon polygon) {
    this.polygon = polygon;
    points = polygon.points();
    rings = Rings.ofChain(points);
    walk = null;
    positions = null;
    after = null;
    before = null;
  }

  private Region(Rings rings) {
    this.rings = rings;
    points = rings.points();
    polygon = null;
    walk = new int[rings.ringVertices()];
    positions = new int[points.size()];
    after = new int[walk.length];
    before = new int[walk.length];
    Arrays.fill(positions, Points.NONE);
    int first = 0;
    for (int r = 0; r < rings.count(); r++) {
      int size = rings.size(r);
      boolean reversed = isClockwise(r) != r > 0;
      for (int k = 0; k < size; k++) {
        int v = rings.vertex(r, reversed && k > 0 ? size - k : k);
        walk[first + k] = v;
        positions[v] = first + k;
        after[first + k] = k + 1 == size ? first : first + k + 1;
        before[first + k] = k == 0 ? first + size - 1 : first + k - 1;
      }
      first += size;
    }
  }

  /** The inside of a polygon. */
  public static Region of(SimplePolygon polygon) {
    return new Region(polygon);
  }

  /**
   * The region that these rings bound, in O(n log n).
   *
   * @throws InvalidGeometryException if they bound none
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Region of(Rings rings, Progress progress) {
    SimplicityCheck.firstDefect(rings, progress)
        .ifPresent(
            defect -> {
              throw new InvalidGeometryException(defect);
            });
    return new Region(rings);
  }

  /** The turn at the lowest vertex decides, which is never straight. */
  private boolean isClockwise(int r) {
    int lowest = rings.vertex(r, 0);
    for (int k = 1; k < rings.size(r); k++) {
      int v = rings.vertex(r, k);
      lowest = points.yxLess(v, lowest) ? v : lowest;
    }
    return points.orient(rings.before(lowest), lowest, rings.after(lowest)) < 0;
  }

  /** All vertices, those of rings and the sites. */
  public Points points() {
    return points;
  }

  /** The number of vertices. */
  public int size() {
    return points.size();
  }

  /** The rings as they were given. */
  public Rings rings() {
    return rings;
  }

  /** Whether it is a simple polygon: no holes, no sites, no fixed edges. */
  public boolean isPolygon() {
    return polygon != null;
  }

  /** The number of positions: of the vertices on rings. */
  public int positions() {
    return walk == null ? points.size() : walk.length;
  }

  /** The vertex at this position. */
  public int vertex(int position) {
    return walk == null ? polygon.vertex(position) : walk[position];
  }

  /** The vertices by their positions. */
  public int[] walk() {
    int[] vertices = new int[positions()];
    Arrays.setAll(vertices, this::vertex);
    return vertices;
  }

  /** The position of this vertex, or {@link Points#NONE} of a site. */
  public int position(int v) {
    return positions == null ? polygon.vertex(v) : positions[v]; // of a polygon its own inverse
  }

  /** The position after this one on its ring. */
  public int after(int position) {
    if (after == null) {
      return position + 1 == points.size() ? 0 : position + 1;
    }
    return after[position];
  }

  /** The position before this one on its ring. */
  public int before(int position) {
    if (before == null) {
      return position == 0 ? points.size() - 1 : position - 1;
    }
    return before[position];
  }

  /** The number of holes, k. */
  public int holes() {
    return rings.count() - 1;
  }

  /** The number of sites, i. */
  public int sites() {
    return points.size() - positions();
  }

  /** The number of triangles that every triangulation has. */
  public int triangles() {
    return 2 * sites() + positions() + 2 * holes() - 2;
  }

  /** Whether these vertices are the ends of a fixed edge. */
  public boolean isFixed(int u, int v) {
    return rings.isFixed(u, v);
  }
}
