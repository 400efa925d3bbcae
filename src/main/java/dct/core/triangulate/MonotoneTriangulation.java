package dct.core.triangulate;

import dct.core.Progress;
import dct.core.geometry.SimplePolygon;

/** To be written. */
public final class MonotoneTriangulation {

  private MonotoneTriangulation() {}

  public static Triangulation triangulate(SimplePolygon polygon, Progress progress) {
    return null;
  }
}
