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

/** Explains the bound of {@link LongSideBound}: the side is drawn, and its sites are counted. */
final class LongSideMarks {
  private LongSideMarks() {}

  static Explanation of(HullRing ring, ParityGoal goal) {
    LongSideBound.Side side = LongSideBound.best(ring, goal);
    List<Mark> marks = new ArrayList<>();
    for (int k = side.corner(); k <= side.corner() + side.inside(); k++) {
      marks.add(new Mark.Segment(ring.site(k), ring.site(k + 1), Tone.MAIN));
    }
    for (int j = 1; j <= side.inside(); j++) {
      int v = ring.site(side.corner() + j);
      Tone tone = goal.wish(v) == Wish.EVEN ? Tone.MAIN : Tone.ONE;
      marks.add(new Mark.Vertex(v, tone, Integer.toString(j)));
    }
    int i = ring.interior();
    int m = side.inside();
    int r = side.others(ring);
    return new Explanation(
        "One side of the hull is long, and little is behind it",
        List.of(
            String.format(
                Locale.ROOT,
                "%d sites lie inside one side of the hull, %d on the rest of it, %d within: every"
                    + " triangulation has 2 × %d + %d + %d = %d triangles.",
                m,
                r,
                i,
                i,
                m,
                r,
                2 * i + m + r),
            String.format(
                Locale.ROOT,
                "The %d edges of the side lie on as many triangles, which leaves %d. Each site"
                    + " inside the side has two of the former, and is even only if it has one of"
                    + " the latter, too; none of these serves two, since sites of one side are"
                    + " joined only along it.",
                m + 1,
                2 * i + r - 1),
            String.format(
                Locale.ROOT,
                "So at most %d of the %d that are wished even are so, and at least %d are not.",
                2 * i + r - 1,
                side.wishedEven(),
                side.odd(ring))),
        marks);
  }
}
