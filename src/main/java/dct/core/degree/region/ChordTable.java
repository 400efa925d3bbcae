package dct.core.degree.region;

import dct.core.dcel.Dcel;
import java.util.ArrayList;
import java.util.List;

/**
 * The best triangulation of a simple polygon, when each vertex has a cost for an even number of
 * triangles and one for an odd number: a table over its chords, exact.
 *
 * <p>Let i &lt; j be the ends of a chord, an edge or a diagonal, and P(i, j) the part of the
 * polygon between the chord and the boundary from i to j. For each parity p of the triangles that
 * P(i, j) puts at i, and q at j, the table holds the least cost of the vertices strictly between i
 * and j. With the apex k of the triangle on the chord,
 *
 * <pre>f(i, j)[1−p][1−q] = min over k, r, s of f(i, k)[p][r] + w(k, 1+r+s) + f(k, j)[s][q]</pre>
 *
 * where w(k, t) is the cost of t triangles at k, modulo 2: k has besides the triangle on the chord
 * only those counted by r and s. An edge of the polygon has f[0][0] = 0 and no other entry. A chord
 * may have a cost of its own, which is added to its entries.
 *
 * <p>What costs are is left to the kinds of table: small numbers ({@link UnmetTable}), or pairs of
 * a number and of what is preferred where that is equal ({@link PreferredTable}).
 */
public abstract class ChordTable {

  /** The number of vertices. */
  abstract int size();

  /** The parities, 2p + q, that the best triangulation has at the ends of the last edge. */
  abstract int ends();

  /**
   * The triangle on the chord (i, j) in the best triangulation with these parities at its ends.
   *
   * @return its apex k, and the parities at the ends of the chords (i, k) and (k, j), as 16k + 4(2p
   *     + r) + 2s + q
   */
  abstract int triangle(int i, int j, int ends);

  /**
   * Cuts the face by the diagonals of a best triangulation.
   *
   * @param corner by position: the half-edge of the face that leaves the vertex there
   */
  public final void cut(Dcel dcel, int[] corner) {
    List<Chord> waiting = new ArrayList<>();
    waiting.add(new Chord(0, size() - 1, ends(), corner[size() - 1]));
    while (!waiting.isEmpty()) {
      Chord chord = waiting.remove(waiting.size() - 1);
      if (chord.j > chord.i + 1) {
        cutAtApex(dcel, corner, chord, waiting);
      }
    }
  }

  /**
   * A chord whose part is still whole.
   *
   * @param i its lower position
   * @param j its higher position
   * @param ends the parities of the triangles of the part at its ends, 2p + q
   * @param back the half-edge along the chord that leaves j, with the part on its left
   */
  private record Chord(int i, int j, int ends, int back) {}

  private void cutAtApex(Dcel dcel, int[] corner, Chord chord, List<Chord> waiting) {
    int i = chord.i;
    int j = chord.j;
    int triangle = triangle(i, j, chord.ends);
    int k = triangle >> 4;
    int backLeft = k == i + 1 ? Dcel.NONE : dcel.splitFace(corner[i], corner[k]) ^ 1;
    int backRight = j == k + 1 ? Dcel.NONE : dcel.splitFace(corner[k], chord.back) ^ 1;
    waiting.add(new Chord(i, k, triangle >> 2 & 3, backLeft));
    waiting.add(new Chord(k, j, triangle & 3, backRight));
  }
}
