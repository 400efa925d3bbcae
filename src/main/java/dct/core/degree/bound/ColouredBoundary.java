package dct.core.degree.bound;

import dct.core.degree.Explanation;
import dct.core.degree.Mark;
import dct.core.degree.Mark.Tone;
import dct.core.degree.ParityGoal;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Explains the bound of {@link BoundaryColouring} for wishes: a cheapest colouring is drawn. */
final class ColouredBoundary {
  private ColouredBoundary() {}

  /**
   * The explanation.
   *
   * @param boundary the vertices along the boundary
   * @param goal what is wished; all inner vertices even
   */
  static Explanation of(int[] boundary, ParityGoal goal) {
    int h = boundary.length;
    boolean[] changes = BoundaryColouring.cheapest(h, k -> goal.wish(boundary[k]));
    List<Mark> marks = new ArrayList<>();
    List<Mark> missed = new ArrayList<>();
    boolean black = true; // the colour of the edge before vertex 0
    int blacks = 0;
    for (int k = 0; k < h; k++) {
      black ^= changes[k];
      blacks += black ? 1 : 0;
      Tone tone = black ? Tone.BLACK : Tone.WHITE;
      marks.add(new Mark.Segment(boundary[k], boundary[(k + 1) % h], tone));
      if (goal.wish(boundary[k]).penalty(changes[k] ? 1 : 2) > 0) {
        missed.add(new Mark.Vertex(boundary[k], Tone.FAULT, changes[k] ? "odd" : "even"));
      }
    }
    marks.addAll(missed);
    boolean isAll = h == goal.size();
    return new Explanation(
        "The colours of the boundary must agree",
        List.of(
            (isAll ? "The" : "If all vertices inside are even, the")
                + " triangles can be coloured black and white so that neighbours differ. At an even"
                + " boundary vertex both boundary edges have one colour, at an odd one it changes.",
            String.format(
                Locale.ROOT,
                "Counting sides, black less white boundary edges is a multiple of 3; and the"
                    + " colour must be the same again after the %d vertices of the boundary.",
                h),
            String.format(
                Locale.ROOT,
                "Every such colouring misses at least %s on the boundary%s. The one drawn has %d"
                    + " black and %d white edges, and misses the wishes that are marked.",
                missed.size() == 1 ? "1 wish" : missed.size() + " wishes",
                isAll ? "" : ", unless one inside is missed",
                blacks,
                h - blacks)),
        marks);
  }
}
