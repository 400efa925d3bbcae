package dct.core.degree.bound;

import dct.core.degree.Explanation;
import dct.core.degree.Mark;
import dct.core.degree.Mark.Tone;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Explains the bound of {@link Handshake}: the vertices wished odd are counted. */
final class HandshakeMarks {
  private HandshakeMarks() {}

  static Explanation of(ParityGoal goal) {
    List<Mark> marks = new ArrayList<>();
    for (int v = 0; v < goal.size(); v++) {
      if (goal.wish(v) == Wish.ODD) {
        marks.add(new Mark.Vertex(v, Tone.MAIN, Integer.toString(marks.size() + 1)));
      }
    }
    int odd = marks.size();
    boolean isForced = new Handshake(goal).bound().value() > 0;
    String count =
        isForced
            ? String.format(
                Locale.ROOT,
                "%d vertices are wished odd and all others even; %d is odd, so that at least one"
                    + " wish is missed.",
                odd,
                odd)
            : goal.count(Wish.ANY) > 0
                ? "Some vertices are left free, so that this forbids nothing, and no other bound"
                    + " that is known says more."
                : String.format(
                    Locale.ROOT,
                    "%d vertices are wished odd, an even number, so that this forbids nothing, and"
                        + " no other bound that is known says more.",
                    odd);
    return new Explanation(
        "The number of odd vertices of a graph is even",
        List.of("Every edge has two ends, so that the degrees add up to an even number.", count),
        marks);
  }
}
