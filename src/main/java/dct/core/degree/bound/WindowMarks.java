package dct.core.degree.bound;

import dct.core.degree.Explanation;
import dct.core.degree.LocalBound;
import dct.core.degree.Mark;
import dct.core.degree.Mark.Tone;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Box;
import dct.core.geometry.Points;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** Explains the bound of {@link WindowBound}: each window is drawn, with its sites. */
final class WindowMarks {
  private static final Tone[] TONES = {Tone.ONE, Tone.TWO};

  private WindowMarks() {}

  /** The explanation of these windows, which have no site in common. */
  static Explanation of(Points points, ParityGoal goal, List<LocalBound> windows) {
    List<Mark> marks = new ArrayList<>();
    for (int k = 0; k < windows.size(); k++) {
      mark(points, windows.get(k), TONES[k % 2], Integer.toString(k + 1), marks);
    }
    String fault = goal.isAll(Wish.EVEN) ? "be all even" : "be granted all wishes";
    String missed = goal.isAll(Wish.EVEN) ? "is odd" : "misses its wish";
    return new Explanation(
        (windows.size() == 1 ? "One window cannot " : windows.size() + " windows cannot ") + fault,
        List.of(
            "A window is the set of sites in a box. Suppose that a triangulation had exactly some"
                + " odd vertices there, and draw a ray from each of them. Then the triangles at the"
                + " window can be coloured black and white so that neighbours differ, but for an"
                + " exchange of the colours across each ray.",
            "So each inner edge at the window has a black triangle on one side and a white one on"
                + " the other, and each hull edge one triangle. For each window marked, every"
                + " choice of empty triangles and colours was refuted in which no site "
                + missed
                + (LocalBound.sum(windows) > windows.size() ? ", or too few." : "."),
            sum(windows)),
        marks);
  }

  private static void mark(
      Points points, LocalBound window, Tone tone, String label, List<Mark> marks) {
    int[] sites = window.sites().stream().toArray();
    Box box = Box.of(Points.ofPairs(coordinates(points, sites)));
    marks.add(new Mark.Band(box.minX(), box.minY(), box.maxX(), box.maxY(), tone, label));
    for (int v : sites) {
      marks.add(new Mark.Vertex(v, tone, ""));
    }
  }

  private static double[] coordinates(Points points, int[] sites) {
    double[] pairs = new double[2 * sites.length];
    for (int i = 0; i < sites.length; i++) {
      pairs[2 * i] = points.x(sites[i]);
      pairs[2 * i + 1] = points.y(sites[i]);
    }
    return pairs;
  }

  private static String sum(List<LocalBound> windows) {
    String terms =
        windows.stream()
            .map(window -> Integer.toString(window.unmet()))
            .collect(Collectors.joining(" + "));
    return windows.size() == 1
        ? "So it has " + terms + " such site at least in every triangulation, or more."
        : "The windows have no site in common, so that every triangulation has "
            + terms
            + " = "
            + LocalBound.sum(windows)
            + " such sites at least.";
  }
}
