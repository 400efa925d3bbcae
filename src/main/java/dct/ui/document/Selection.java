package dct.ui.document;

import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.BitSet;

/** Which vertices of a document are selected; immutable. A bit each. */
public final class Selection {
  /** No vertex. */
  public static final Selection NONE = new Selection(new BitSet());

  private final BitSet vertices;
  private final int count;

  private Selection(BitSet vertices) {
    this.vertices = vertices;
    count = vertices.cardinality();
  }

  /** The vertices whose bits are set; the set is copied. */
  public static Selection of(BitSet vertices) {
    return vertices.isEmpty() ? NONE : new Selection((BitSet) vertices.clone());
  }

  /** These vertices. */
  public static Selection of(int... vertices) {
    BitSet set = new BitSet();
    Arrays.stream(vertices).forEach(set::set);
    return of(set);
  }

  /** The vertices from the first to before the end. */
  public static Selection range(int first, int end) {
    BitSet set = new BitSet(end);
    set.set(first, end);
    return of(set);
  }

  /** Whether no vertex is selected. */
  public boolean isEmpty() {
    return count == 0;
  }

  /** How many vertices are selected. */
  public int count() {
    return count;
  }

  /** Whether vertex v is selected. */
  public boolean has(int v) {
    return vertices.get(v);
  }

  /** The first selected vertex from v on; −1 if there is none. */
  public int next(int v) {
    return vertices.nextSetBit(v);
  }

  /** The last selected vertex; −1 if there is none. */
  public int last() {
    return vertices.length() - 1;
  }

  /** The numbers of the selected vertices, in their order. */
  public int[] numbers() {
    return vertices.stream().toArray();
  }

  /** This selection with vertex v selected if it was not, and else without it. */
  public Selection toggled(int v) {
    BitSet set = (BitSet) vertices.clone();
    set.flip(v);
    return of(set);
  }

  /** What is selected here or there. */
  public Selection or(Selection other) {
    BitSet set = (BitSet) vertices.clone();
    set.or(other.vertices);
    return of(set);
  }

  /** The points of the selected vertices, in their order. */
  public Points of(Points points) {
    double[] x = new double[count];
    double[] y = new double[count];
    int k = 0;
    for (int v = next(0); v >= 0; v = next(v + 1)) {
      x[k] = points.x(v);
      y[k++] = points.y(v);
    }
    return Points.of(x, y);
  }

  /**
   * The same vertices after a change of the points, in linear time: by their numbers where points
   * have moved, and by their places where some have come or gone. Nothing if the points are others
   * altogether.
   */
  Selection following(Points before, Points after) {
    if (isEmpty()) {
      return this;
    }
    if (before.size() == after.size()) {
      return count == before.size() || haveOneInCommon(before, after) ? this : NONE;
    }
    return before.size() < after.size() ? grown(before, after) : shrunk(before, after);
  }

  private static boolean haveOneInCommon(Points before, Points after) {
    for (int v = 0; v < before.size(); v++) {
      if (same(before, v, after, v)) {
        return true;
      }
    }
    return false;
  }

  private Selection grown(Points before, Points after) {
    BitSet set = new BitSet();
    int v = 0; // of the points before
    for (int w = 0; w < after.size() && v < before.size(); w++) {
      if (same(before, v, after, w)) {
        set.set(w, has(v));
        v++;
      }
    }
    return v == before.size() ? of(set) : NONE;
  }

  private Selection shrunk(Points before, Points after) {
    BitSet set = new BitSet();
    int w = 0; // of the points after
    for (int v = 0; v < before.size() && w < after.size(); v++) {
      if (same(before, v, after, w)) {
        set.set(w, has(v));
        w++;
      }
    }
    return w == after.size() ? of(set) : NONE;
  }

  private static boolean same(Points a, int v, Points b, int w) {
    return a.x(v) == b.x(w) && a.y(v) == b.y(w);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Selection that && vertices.equals(that.vertices);
  }

  @Override
  public int hashCode() {
    return vertices.hashCode();
  }

  @Override
  public String toString() {
    return vertices.toString();
  }
}
