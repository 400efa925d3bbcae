package dct.core.degree;

import dct.core.triangulate.Triangulation;

/** To be written. */
public final class ScanFlip {

  private ScanFlip() {}

  public static FlipResult run(Triangulation triangulation) {
    return null;
  }
}
