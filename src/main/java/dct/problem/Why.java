package dct.problem;

import dct.core.Progress;
import dct.core.degree.Explanation;
import dct.core.degree.Mark;
import dct.core.degree.Mark.Tone;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.BoundExplanation;
import dct.core.degree.exact.ExactSites;
import dct.core.degree.region.ParityTable;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.core.triangulate.VisibilityGraph;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Explains what is known of how good a solution is: first what was found and what is proven, then
 * why the bound holds, with marks for the picture.
 */
public final class Why {
  private final Solution solution;
  private final ParityGoal goal;
  private final int unmet;
  private final int bound;

  private Why(Solution solution) {
    this.solution = solution;
    goal =
        solution
            .optimum()
            .map(best -> best.goal())
            .orElseGet(() -> ParityGoal.allEven(solution.instance().size()));
    unmet = solution.unmet();
    bound = solution.bound().value();
  }

  /**
   * The explanation. It takes as long as the bounds that have to be computed again: mostly no time
   * to speak of, some seconds for a walk round a large hull or for windows.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Explanation of(Solution solution, Progress progress) {
    return new Why(solution).explanation(progress);
  }

  private Explanation explanation(Progress progress) {
    Triangulation triangulation = solution.triangulation();
    return BoundExplanation.of(triangulation, goal, solution.bound(), progress)
        .or(() -> exact(progress))
        .orElseGet(this::unexplained)
        .after(known());
  }

  private List<String> known() {
    String counted = goal.isAll(Wish.EVEN) ? "odd vertices" : "wishes that are not granted";
    String count = count(counted, unmet);
    if (unmet == 0) {
      return List.of("There are no " + counted + ", and nothing can be better than that.");
    }
    if (unmet == bound) {
      return List.of(
          (unmet == 1 ? "There is " : "There are ")
              + count
              + ", and it is proven that no triangulation has fewer. Why?");
    }
    return List.of(
        String.format(
            Locale.ROOT,
            (unmet == 1 ? "There is %s" : "There are %s")
                + ". It is proven that every triangulation has %s; that does not tell whether"
                + " one has fewer than %d.",
            count,
            bound == 0 ? "none or more" : bound + " or more",
            unmet),
        "To prove this one the best, the bound would have to rise by "
            + (unmet - bound)
            + "; to refute it, a triangulation with fewer has to be found. A search for the most"
            + " even vertices, or the most granted wishes, tries both.",
        "Why does the bound hold?");
  }

  private static String count(String what, int count) {
    boolean isOne = count == 1;
    return count
        + " "
        + (isOne
            ? what.replace("vertices", "vertex").replace("wishes that are", "wish that is")
            : what);
  }

  // ---- bounds that rest on all triangulations

  private Optional<Explanation> exact(Progress progress) {
    Triangulation triangulation = solution.triangulation();
    if (triangulation.domain() == Domain.SITES) {
      boolean isPolygon = triangulation.boundaryCount() == triangulation.vertexCount();
      return isPolygon || ExactSites.canSolve(triangulation)
          ? Optional.of(explained(isPolygon ? hullTable() : sweep()))
          : Optional.empty();
    }
    return table(progress).map(this::explained);
  }

  private String sweep() {
    return String.format(
        Locale.ROOT,
        "All triangulations were looked at. A table holds, for every path from the first to the"
            + " last of the %d sites in the order of a sweep and for all parities along it, the"
            + " fewest wishes that can be missed on its one side. Triangle by triangle the path"
            + " moves over all sites; what is left in the end is %d.",
        solution.instance().size(),
        bound);
  }

  private String hullTable() {
    return String.format(
        Locale.ROOT,
        "No site lies inside the hull, so that the %d sites are the corners of a polygon. A table"
            + " over all pairs of them and the parities at both holds the fewest wishes that can be"
            + " missed on one side of their diagonal; for the whole polygon that is %d.",
        solution.instance().size(),
        bound);
  }

  private Optional<String> table(Progress progress) {
    if (!(solution.instance() instanceof Instance.OfPolygon of)) {
      return Optional.empty();
    }
    return Optional.ofNullable(
            VisibilityGraph.of(
                of.polygon(), solution.triangulation(), SearchLimits.MOST_PAIRS, progress))
        .map(
            graph ->
                String.format(
                    Locale.ROOT,
                    "All triangulations were looked at. %d pairs of the %d vertices see each other,"
                        + " neighbours included, and form at most %d triangles. A table over the"
                        + " pairs and the parities at both ends holds the fewest wishes that can be"
                        + " missed on one side of the diagonal, computed from the triangles there;"
                        + " for the whole polygon that is %d.",
                    graph.pairs(),
                    graph.vertices(),
                    ParityTable.steps(graph),
                    bound));
  }

  private Explanation explained(String how) {
    return new Explanation("Every triangulation was counted", List.of(how), unmetMarks());
  }

  private Explanation unexplained() {
    return new Explanation(
        "Proven by a longer computation",
        List.of(
            "The reason given is: "
                + solution.bound().reason()
                + ". It is too long to be repeated here; Verify Result computes it again."),
        unmetMarks());
  }

  private List<Mark> unmetMarks() {
    List<Mark> marks = new ArrayList<>();
    Triangulation triangulation = solution.triangulation();
    for (int v = 0; v < triangulation.vertexCount(); v++) {
      if (!goal.isGranted(triangulation, v)) {
        marks.add(new Mark.Vertex(v, Tone.FAULT, Integer.toString(triangulation.degree(v))));
      }
    }
    return marks;
  }
}
