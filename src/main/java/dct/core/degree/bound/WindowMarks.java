package dct.core.degree.bound;

import dct.core.degree.Explanation;
import dct.core.degree.Mark;
import dct.core.degree.Mark.Tone;
import dct.core.geometry.Box;
import dct.core.geometry.Points;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Explains the bound of {@link WindowBound}: each window that was refuted is drawn. */
final class WindowMarks {
  private static final Tone[] TONES = {Tone.ONE, Tone.TWO};

  private WindowMarks() {}

  /** The explanation of these windows, each a list of sites. */
  static Explanation of(Points points, List<int[]> windows, boolean byX) {
    Box all = Box.of(points);
    List<Mark> marks = new ArrayList<>();
    for (int k = 0; k < windows.size(); k++) {
      Tone tone = TONES[k % 2];
      double low = Double.POSITIVE_INFINITY;
      double high = Double.NEGATIVE_INFINITY;
      for (int v : windows.get(k)) {
        low = Math.min(low, byX ? points.x(v) : points.y(v));
        high = Math.max(high, byX ? points.x(v) : points.y(v));
      }
      String label = Integer.toString(k + 1);
      marks.add(
          byX
              ? new Mark.Band(low, all.minY(), high, all.maxY(), tone, label)
              : new Mark.Band(all.minX(), low, all.maxX(), high, tone, label));
      for (int v : windows.get(k)) {
        marks.add(new Mark.Vertex(v, tone, ""));
      }
    }
    int count = windows.size();
    return new Explanation(
        count == 1 ? "One window cannot be all even" : count + " windows cannot be all even",
        List.of(
            "A window is the set of sites in a strip. If all of them were even, the triangles at"
                + " them could be coloured black and white so that neighbours differ, and along the"
                + " hull the colour would not change.",
            "So each inner edge at them would have one black and one white triangle, and each hull"
                + " edge one triangle. For each window marked, every choice of empty triangles and"
                + " colours was refuted: one of its sites is odd in every triangulation.",
            String.format(
                Locale.ROOT,
                "The windows have no site in common: %s. The number of odd vertices is even.",
                count == 1
                    ? "there is 1, and at least 1 site is odd"
                    : "there are " + count + ", and at least " + count + " sites are odd")),
        marks);
  }
}
