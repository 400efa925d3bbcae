package dct.core.degree.bound;

import dct.core.degree.Explanation;
import dct.core.degree.Mark;
import dct.core.degree.Mark.Tone;
import dct.core.degree.colour.HullRing;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Explains the bound of {@link ThreeHullSites}: the three are drawn, and what is possible. */
final class ThreeHullMarks {
  private static final String[] WHY = {
    "Four sites of which three are on the hull have one triangulation, in which each is joined to"
        + " the three others: all four are odd.",
    "Five vertices have 9 edges and degrees of 3 or 4, which add up to 18 only as 3, 3, 4, 4, 4:"
        + " two are odd.",
    "Six vertices have 12 edges and degrees of 3 or more, which add up to 24. Either all have"
        + " degree 4; or one has degree 3, and without it five vertices are left with degrees 3, 3,"
        + " 4, 4, 4. Put back, it makes 3, 3, 4, 4, 5, 5: four are odd, never two.",
    "Seven vertices have 15 edges. If all were even, one would have degree 6 and the others 4. The"
        + " one of degree 6 is joined to all others, which form a ring; the other side of the ring"
        + " is a hexagon cut by three diagonals, one end at each corner. But two corners of a"
        + " triangulated hexagon have no diagonal."
  };

  private ThreeHullMarks() {}

  static Explanation of(HullRing ring, int bound) {
    int n = ring.points().size();
    List<Mark> marks = new ArrayList<>();
    for (int k = 0; k < ring.size(); k++) {
      marks.add(new Mark.Segment(ring.site(k), ring.site(k + 1), Tone.MAIN));
      marks.add(new Mark.Vertex(ring.site(k), Tone.MAIN, Integer.toString(k + 1)));
    }
    return new Explanation(
        "Only three of the " + n + " sites are on the hull",
        List.of(
            "A triangulation whose boundary is a triangle has 3 × "
                + n
                + " − 6 edges, and no vertex of degree 2.",
            WHY[n - 4],
            String.format(
                Locale.ROOT,
                "Of what is left possible here, at least %d %s missed.",
                bound,
                bound == 1 ? "wish is" : "wishes are")),
        marks);
  }
}
