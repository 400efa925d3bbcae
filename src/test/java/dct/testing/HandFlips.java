package dct.testing;

import dct.core.degree.Flip;
import dct.core.degree.FlipResult;
import dct.core.degree.FlipWalk;
import dct.core.triangulate.Triangulation;

/** Flips as a person makes them: in no order, some edges again, some back. */
public final class HandFlips {
  private HandFlips() {}

  /** At least so many flips of a triangulation. */
  public static FlipResult of(Triangulation start, int count) {
    FlipResult flips = FlipResult.of(new FlipWalk(start));
    for (int k = 0; flips.flips() < count; k++) {
      int edge = (int) (k * 7919L % start.edgeCount());
      if (Flip.at(flips.after(), edge).isPresent()) {
        flips = flips.then(edge);
        flips = k % 3 == 0 ? flips.then(edge) : flips;
      }
    }
    return flips;
  }
}
