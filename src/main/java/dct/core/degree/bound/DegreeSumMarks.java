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

/** Explains the bound of {@link DegreeSumBound}: the corners that may have degree 2 are drawn. */
final class DegreeSumMarks {
  private DegreeSumMarks() {}

  static Explanation of(HullRing ring, ParityGoal goal) {
    int n = goal.size();
    int h = ring.size();
    List<Mark> marks = new ArrayList<>();
    List<Mark> labels = new ArrayList<>();
    boolean[] isCutOff = new boolean[n];
    for (int k : DegreeSumBound.cutOff(ring, goal)) {
      marks.add(
          new Mark.Area(List.of(ring.site(k - 1), ring.site(k), ring.site(k + 1)), Tone.MAIN));
      labels.add(new Mark.Vertex(ring.site(k), Tone.MAIN, "2"));
      isCutOff[ring.site(k)] = true;
    }
    int ears = marks.size();
    for (int v = 0; v < n; v++) {
      if (!isCutOff[v]) {
        boolean even = goal.wish(v) == Wish.EVEN;
        labels.add(new Mark.Vertex(v, even ? Tone.TWO : Tone.ONE, even ? "4" : "3"));
      }
    }
    marks.addAll(labels);
    int even = goal.count(Wish.EVEN);
    return new Explanation(
        "The degrees add up to too little",
        List.of(
            String.format(
                Locale.ROOT,
                "%d sites, %d of them on the hull, have 3 × %d − 3 − %d = %d edges in every"
                    + " triangulation, so that the degrees add up to %d.",
                n,
                h,
                n,
                h,
                3 * n - 3 - h,
                6 * n - 6 - 2 * h),
            String.format(
                Locale.ROOT,
                "A vertex has degree 2 only where it is a corner that forms an empty triangle with"
                    + " its two neighbours on the hull, and two neighbours cannot both: %s. All"
                    + " others have degree 3 or more, and 4 or more where they are even.",
                ears == 0
                    ? "here none can"
                    : ears == 1 ? "here one can, shaded" : "here " + ears + " can, shaded"),
            String.format(
                Locale.ROOT,
                "With all %s the degrees would add up to %d or more, which is %d too much; each"
                    + " wish that is missed saves 1.",
                even == n ? "even" : "wishes granted",
                6 * n - 6 - 2 * h + DegreeSumBound.of(ring, goal).value(),
                DegreeSumBound.of(ring, goal).value())),
        marks);
  }
}
