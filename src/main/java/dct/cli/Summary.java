package dct.cli;

import dct.core.degree.DegreeCount;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.triangulate.Triangulation;
import dct.io.text.Shown;
import dct.problem.Instance;
import dct.problem.Solution;
import java.util.Locale;
import java.util.Optional;

/** A solution in a few lines for a person. */
final class Summary {
  private Summary() {}

  static String of(Solution solution) {
    StringBuilder text = new StringBuilder(what(solution)).append('\n');
    Optional<DegreeCount> before = solution.countsBefore();
    if (before.isPresent()) {
      int flips = solution.flips().orElseThrow().flips();
      text.append("before: ").append(counts(before.get())).append("\nafter ");
      text.append(flips).append(flips == 1 ? " flip: " : " flips: ");
    }
    return text.append(counts(solution.counts())).append(bound(solution)).toString();
  }

  private static String what(Solution solution) {
    Instance instance = solution.instance();
    Triangulation made = solution.triangulation();
    return String.format(
        Locale.ROOT,
        "%s: %d %s%s, %s: %d edges, %d triangles",
        Shown.harmless(instance.name()),
        instance.size(),
        instance.domain().vertices(),
        instance.mergedRemark(),
        solution.methodWord(),
        made.edgeCount(),
        made.triangleCount());
  }

  private static String counts(DegreeCount count) {
    return count.even() + " even, " + count.odd() + " odd";
  }

  private static String bound(Solution solution) {
    if (solution.optimum().isPresent()) {
      String preferred = solution.preferred().map(best -> "; " + best.words()).orElse("");
      return bound(solution.optimum().get()) + preferred;
    }
    if (solution.isProven()) {
      return "; no triangulation has fewer odd vertices";
    }
    int bound = solution.oddBound().value();
    return bound == 0 ? "" : "; every triangulation has " + bound + " or more odd vertices";
  }

  private static String bound(Optimum best) {
    String wishes =
        best.goal().isAll(ParityGoal.Wish.EVEN)
            ? ""
            : String.format(
                Locale.ROOT,
                "; %d of %d wishes granted",
                best.goal().size() - best.unmet(),
                best.goal().size());
    return wishes + "; " + best.verdict();
  }
}
