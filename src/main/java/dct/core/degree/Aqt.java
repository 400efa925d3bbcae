package dct.core.degree;

import dct.core.Progress;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Triangulation;

/** To be written. */
public final class Aqt {

  private Aqt() {}

  public static Triangulation triangulate(SimplePolygon polygon, Progress progress) {
    return null;
  }
}
