package dct.core.geometry;

import java.util.Arrays;
import java.util.List;

/** A part of the inside of touching rings that hangs together: {@link Touching#pieces}. */
public final class Piece {
  private final int[] vertices;
  private final List<int[]> rings;
  private final int[] fixed;
  private final boolean isPinched;

  Piece(int[] vertices, List<int[]> rings, int[] fixed, boolean isPinched) {
    this.vertices = vertices;
    this.rings = List.copyOf(rings);
    this.fixed = fixed;
    this.isPinched = isPinched;
  }

  /**
   * Which vertex each of its vertices is, in ascending order; where it touches itself there are
   * several at one place. A copy.
   */
  public int[] vertices() {
    return vertices.clone();
  }

  /** Its rings, by its own numbers of vertices, the outer one first. */
  public List<int[]> rings() {
    return rings;
  }

  /** The ends of its fixed edges by its own numbers, two an edge; a copy. */
  public int[] fixed() {
    return fixed.clone();
  }

  /**
   * Its rings and fixed edges among its own vertices.
   *
   * @param points the points that {@link Touching#pieces} was asked about
   */
  public Rings toRings(Points points) {
    double[] x = Arrays.stream(vertices).mapToDouble(points::x).toArray();
    double[] y = Arrays.stream(vertices).mapToDouble(points::y).toArray();
    return Rings.of(Points.of(x, y), rings, fixed);
  }

  /** Whether it touches itself, so that only a hair parts it. */
  public boolean isPinched() {
    return isPinched;
  }
}
