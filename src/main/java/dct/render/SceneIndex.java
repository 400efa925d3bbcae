package dct.render;

import dct.core.Progress;
import dct.core.geometry.HilbertOrder;
import dct.core.geometry.Points;
import java.util.List;

/**
 * The vertices and edges of a scene by place: sorted along a Hilbert curve and cut into {@link
 * Blocks}, so that a painter passes over what is out of sight or too small to be seen, and finds
 * what it draws side by side in memory. O(n log n) to make; immutable.
 */
final class SceneIndex {
  private final int[] vertices; // their numbers, along the curve
  private final int[] places; // along the curve, by vertex
  private final boolean[] odd; // along the curve; null while nothing is triangulated
  private final int oddCount;
  private final double[] x; // along the curve
  private final double[] y;
  private final Blocks blocks;
  private final List<IndexedEdges> layers;

  private SceneIndex(
      int[] vertices,
      int[] places,
      boolean[] odd,
      double[] x,
      double[] y,
      List<IndexedEdges> layers) {
    this.vertices = vertices;
    this.places = places;
    this.odd = odd;
    this.x = x;
    this.y = y;
    this.layers = layers;
    blocks = new Blocks(vertices.length);
    int odds = 0;
    for (int place = 0; place < vertices.length; place++) {
      odds += isOdd(place) ? 1 : 0;
      blocks.include(place, x[place], y[place]);
    }
    blocks.close();
    oddCount = odds;
  }

  /**
   * Sorts the points, and the edges of each layer.
   *
   * @param degrees by vertex, or null while nothing is triangulated
   */
  static SceneIndex of(Points points, int[] degrees, List<EdgeLayer> layers) {
    int[] vertices = HilbertOrder.of(points, Progress.NONE);
    int[] places = new int[vertices.length];
    double[] x = new double[vertices.length];
    double[] y = new double[vertices.length];
    for (int place = 0; place < vertices.length; place++) {
      places[vertices[place]] = place;
      x[place] = points.x(vertices[place]);
      y[place] = points.y(vertices[place]);
    }
    List<IndexedEdges> sorted =
        layers.stream().map(layer -> new IndexedEdges(layer, places, x, y)).toList();
    return new SceneIndex(vertices, places, odd(vertices, degrees), x, y, sorted);
  }

  private static boolean[] odd(int[] vertices, int[] degrees) {
    if (degrees == null) {
      return null;
    }
    boolean[] odd = new boolean[vertices.length];
    for (int place = 0; place < odd.length; place++) {
      odd[place] = (degrees[vertices[place]] & 1) == 1;
    }
    return odd;
  }

  /** The blocks of the vertices, by place. */
  Blocks blocks() {
    return blocks;
  }

  /** The edges, what is drawn first coming first. */
  List<IndexedEdges> layers() {
    return layers;
  }

  /** The colour of the vertex at a place along the curve. */
  Ink ink(int place) {
    if (odd == null) {
      return Ink.VERTEX;
    }
    return odd[place] ? Ink.ODD : Ink.EVEN;
  }

  /** Whether the vertex at a place has odd degree; false while nothing is triangulated. */
  boolean isOdd(int place) {
    return odd != null && odd[place];
  }

  /** How many vertices have odd degree. */
  int oddCount() {
    return oddCount;
  }

  /** The place of vertex v along the curve. */
  int place(int v) {
    return places[v];
  }

  /** The number of the vertex at a place along the curve. */
  int vertex(int place) {
    return vertices[place];
  }

  /** The x-coordinate at a place. */
  double x(int place) {
    return x[place];
  }

  /** The y-coordinate at a place. */
  double y(int place) {
    return y[place];
  }
}
