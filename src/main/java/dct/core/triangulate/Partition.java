package dct.core.triangulate;

import dct.core.dcel.Dcel;
import dct.core.geometry.Region;

/**
 * A region cut into pieces by some of its diagonals.
 *
 * @param region the region, or polygon
 * @param dcel its topology, frozen: the outer face and one face a piece
 */
public record Partition(Region region, Dcel dcel) {

  public Partition {
    dcel.freeze();
  }

  /** The number of pieces. */
  public int pieces() {
    return dcel.faceCount() - 1;
  }
}
