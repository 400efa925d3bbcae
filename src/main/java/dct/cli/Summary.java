package dct.cli;

import dct.core.degree.DegreeCount;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.io.Result;
import java.util.Locale;

/** A result in a few lines for a person. */
final class Summary {
  private Summary() {}

  static String of(Result result) {
    StringBuilder text = new StringBuilder(what(result));
    result
        .post()
        .ifPresent(
            post ->
                text.append("\nbefore: ")
                    .append(counts(post.before()))
                    .append("\nafter ")
                    .append(post.flips() == 1 ? "1 flip" : post.flips() + " flips")
                    .append(':'));
    text.append(result.post().isPresent() ? " " : "\n").append(counts(result.degrees()));
    return text.append(bound(result)).toString();
  }

  private static String what(Result result) {
    Triangulation made = result.triangulation();
    return String.format(
        Locale.ROOT,
        "%s: %d %s%s, %s: %d edges, %d triangles",
        result.input(),
        made.vertexCount(),
        made.domain() == Domain.POLYGON ? "vertices" : "sites",
        merged(result.merged()),
        result.algorithm(),
        made.edgeCount(),
        made.triangleCount());
  }

  /** A remark on merged duplicates, empty if there were none. */
  static String merged(int merged) {
    return merged == 0
        ? ""
        : String.format(Locale.ROOT, " (%d duplicate%s merged)", merged, merged == 1 ? "" : "s");
  }

  private static String counts(DegreeCount count) {
    return count.even() + " even, " + count.odd() + " odd";
  }

  private static String bound(Result result) {
    if (result.optimum().isPresent()) {
      return bound(result.optimum().get());
    }
    if (result.isOptimal()) {
      return "; no triangulation has fewer odd vertices";
    }
    int bound = result.oddLowerBound();
    return bound == 0 ? "" : "; every triangulation has " + bound + " or more odd vertices";
  }

  private static String bound(Optimum best) {
    String wishes =
        best.goal().isAll(ParityGoal.Wish.EVEN)
            ? ""
            : String.format(
                Locale.ROOT,
                "; %d of %d wishes granted",
                best.goal().size() - best.unsatisfied(),
                best.goal().size());
    return wishes + "; " + best.verdict();
  }
}
