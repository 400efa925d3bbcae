package dct.core.triangulate;

import dct.core.dcel.Dcel;
import dct.core.geometry.SimplePolygon;

/**
 * A simple polygon cut into pieces by some of its diagonals.
 *
 * @param polygon the polygon
 * @param dcel its topology, frozen: the outer face and one face a piece
 */
public record Partition(SimplePolygon polygon, Dcel dcel) {

  public Partition {
    dcel.freeze();
  }

  /** The number of pieces. */
  public int pieces() {
    return dcel.faceCount() - 1;
  }
}
