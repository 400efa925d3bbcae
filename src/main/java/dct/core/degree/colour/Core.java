package dct.core.degree.colour;

import java.util.BitSet;

/**
 * What a conflict rests on.
 *
 * @param levels the decisions, by level
 * @param sides the sides of triangles whose signs were used
 */
record Core(BitSet levels, BitSet sides) {

  /** The same without one decision: what its opposite follows from. */
  Core without(int level) {
    BitSet others = (BitSet) levels.clone();
    others.clear(level);
    return new Core(others, sides);
  }
}
