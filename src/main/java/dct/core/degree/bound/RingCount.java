package dct.core.degree.bound;

import dct.core.degree.Explanation;
import dct.core.degree.Mark;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Explains the bound of {@link RegionBounds} for all even: each ring counted in threes. Of numbers
 * that may each be taken with either sign some sum is a multiple of 3, unless just one of them is
 * no multiple.
 */
final class RingCount {
  private RingCount() {}

  /**
   * The explanation.
   *
   * @param rings the vertices along each ring, two rings or more
   */
  static Explanation of(List<int[]> rings) {
    List<Mark> marks = new ArrayList<>();
    List<Integer> indivisible = new ArrayList<>();
    for (int[] ring : rings) {
      marks.addAll(BoundaryCount.marks(ring));
      if (ring.length % 3 > 0) {
        indivisible.add(ring.length);
      }
    }
    boolean forbids = indivisible.size() == 1;
    String title =
        forbids
            ? "3 divides the numbers of vertices of all rings but one"
            : "3 divides a sum and difference of the rings' numbers of vertices";
    return new Explanation(title, sentences(rings.size(), indivisible), marks);
  }

  private static List<String> sentences(int rings, List<Integer> indivisible) {
    String first =
        "Suppose every vertex were even. Then the triangles could be coloured black and white so"
            + " that neighbours differ, and along each ring all boundary edges would lie on"
            + " triangles of one colour.";
    String second =
        "A triangle has three sides, and an inner edge one black and one white side. Counting"
            + " sides, 3 × black − 3 × white is the number of edges of the black rings less that"
            + " of the white ones: 3 would divide it.";
    return List.of(first, second, last(rings, indivisible));
  }

  private static String last(int rings, List<Integer> indivisible) {
    if (indivisible.size() == 1) {
      return String.format(
          Locale.ROOT,
          "Counted in threes, only the ring of %d vertices leaves a rest, which no other ring makes"
              + " good. So there is an odd vertex; and since the number of odd vertices of a graph"
              + " is even, there are two.",
          indivisible.get(0));
    }
    return indivisible.isEmpty()
        ? String.format(
            Locale.ROOT,
            "It does: 3 divides the numbers of all %d rings. So this count forbids nothing.",
            rings)
        : String.format(
            Locale.ROOT,
            "It can: the rests of the %d rings that 3 does not divide cancel out or add up to a"
                + " multiple of 3, if their colours are chosen so. So this count forbids nothing.",
            indivisible.size());
  }
}
