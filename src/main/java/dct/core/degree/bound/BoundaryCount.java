package dct.core.degree.bound;

import dct.core.degree.Explanation;
import dct.core.degree.Mark;
import dct.core.degree.Mark.Tone;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Explains the bound of {@link BoundaryColouring} for all even: the boundary counted in threes. */
final class BoundaryCount {
  private static final Tone[] THREE = {Tone.ONE, Tone.TWO, Tone.THREE};

  private BoundaryCount() {}

  /**
   * The explanation.
   *
   * @param boundary the vertices along the boundary
   * @param what they are called, in the plural: {@code hull sites}
   */
  static Explanation of(int[] boundary, String what) {
    int h = boundary.length;
    int rest = h % 3;
    List<Mark> marks = marks(boundary);
    List<String> sentences = new ArrayList<>();
    sentences.add(
        "Suppose every vertex were even. Then the triangles could be coloured black and white so"
            + " that neighbours differ, and every boundary edge would lie on a black triangle.");
    sentences.add(
        String.format(
            Locale.ROOT,
            "A triangle has three sides, and an inner edge one black and one white side. Counting"
                + " sides, 3 × black = 3 × white + %d: 3 would divide the number of boundary edges,"
                + " which is that of the %s.",
            h,
            what));
    sentences.add(
        rest == 0
            ? String.format(
                Locale.ROOT, "It does: %d = 3 × %d. So this count forbids nothing.", h, h / 3)
            : String.format(
                Locale.ROOT,
                "It does not: counted in threes, %d = 3 × %d + %d. So there is an odd vertex; and"
                    + " since the number of odd vertices of a graph is even, there are two.",
                h,
                h / 3,
                rest));
    String title =
        String.format(
            Locale.ROOT,
            rest == 0 ? "3 divides the %d %s" : "3 does not divide the %d %s",
            h,
            what);
    return new Explanation(title, sentences, marks);
  }

  /** The vertices of a ring counted in threes; those that are left over are faults. */
  static List<Mark> marks(int... ring) {
    List<Mark> marks = new ArrayList<>();
    int rest = ring.length % THREE.length;
    for (int k = 0; k < ring.length; k++) {
      Tone tone = k < ring.length - rest ? THREE[k % THREE.length] : Tone.FAULT;
      marks.add(new Mark.Vertex(ring[k], tone, Integer.toString(k % THREE.length + 1)));
    }
    return marks;
  }
}
