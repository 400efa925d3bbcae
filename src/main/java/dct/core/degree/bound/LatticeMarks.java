package dct.core.degree.bound;

import dct.core.degree.Explanation;
import dct.core.degree.Mark;
import dct.core.degree.Mark.Tone;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.HullRing;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Explains the bound of {@link LatticeBound}: the hull's edges are drawn by their classes. */
final class LatticeMarks {
  private static final Tone[] CLASSES = {null, Tone.ONE, Tone.TWO, Tone.THREE};

  private LatticeMarks() {}

  static Explanation of(Lattice lattice, HullRing ring, ParityGoal goal) {
    int[] sum = LatticeBound.sums(lattice, ring, goal);
    List<Mark> marks = new ArrayList<>();
    for (int k = 0; k < ring.size(); k++) {
      Tone tone = CLASSES[LatticeBound.edgeClass(lattice, ring, k)];
      marks.add(new Mark.Segment(ring.site(k), ring.site(k + 1), tone));
    }
    boolean allEven = goal.isAll(Wish.EVEN);
    return new Explanation(
        "The sites are all points of a lattice in their hull",
        List.of(
            "Every triangle of a triangulation that uses all points of a lattice has one side of"
                + " each of three classes: steps in the lattice that are odd along the first axis"
                + " only, along the second only, or along both.",
            allEven
                ? "Were all vertices even, the triangles could be coloured black and white with"
                    + " the whole boundary on black ones. Every inner edge has a black and a white"
                    + " side, so that each class would have as many boundary edges as there are"
                    + " more black than white triangles: the same number in all three."
                : "Were all wishes granted, the triangles could be coloured black and white, the"
                    + " colour along the boundary changing at odd vertices. Black less white"
                    + " boundary edges would be the same number in each of the three classes.",
            String.format(
                Locale.ROOT,
                "Here the three classes, drawn in three colours, have %d, %d and %d. So a wish is"
                    + " missed%s.",
                sum[1],
                sum[2],
                sum[3],
                allEven
                    ? "; and since the number of odd vertices of a graph is even, two are"
                    : "")),
        marks);
  }
}
