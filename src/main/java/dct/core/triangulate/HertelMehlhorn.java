package dct.core.triangulate;

import dct.core.geometry.SimplePolygon;

/** To be written. */
public final class HertelMehlhorn {

  private HertelMehlhorn() {}

  public static Partition partition(SimplePolygon polygon, Triangulation triangulation) {
    return null;
  }
}
