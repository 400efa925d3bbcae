package dct.core.triangulate;

import dct.core.Progress;
import dct.core.geometry.Sites;

/** To be written. */
public final class Delaunay {

  private Delaunay() {}

  public static Triangulation triangulate(Sites sites, Progress progress) {
    return null;
  }
}
