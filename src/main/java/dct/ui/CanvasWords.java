package dct.ui;

import dct.core.degree.DegreeCount;
import dct.core.geometry.Defect;
import dct.core.triangulate.Domain;
import dct.problem.Solution;
import dct.ui.document.Analysis;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import dct.ui.document.Layout;
import dct.ui.document.Result;
import dct.ui.document.ResultTitle;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** What the canvas shows, in words: what a screen reader says of it. */
final class CanvasWords {

  private CanvasWords() {}

  /** What an editor shows; what to do where there is none. Linear in the vertices. */
  static String of(Optional<Editor> editor) {
    return editor
        .map(CanvasWords::of)
        .orElse("Nothing yet; choose Polygon Based or Point Sites Based");
  }

  private static String of(Editor editor) {
    Document document = editor.visible();
    if (document.size() == 0) {
      return "Empty; the keys of the menu Edit choose a tool";
    }
    boolean pending = !editor.shown().document().isDrawnAs(document);
    return subject(document)
        + (pending ? ", being analysed" : state(document, editor.shown()))
        + (pending ? "" : "; " + triangulation(document, editor.shown()));
  }

  private static String subject(Document document) {
    int n = document.size();
    boolean polygon = document.domain() == Domain.POLYGON;
    String vertices = n == 1 ? (polygon ? "vertex" : "site") : document.domain().vertices();
    String region =
        document.content() == Domain.REGION ? " with " + inside(document.layout(), n) : "";
    return (polygon ? "A polygon of " : "") + n + " " + vertices + region;
  }

  private static String inside(Layout layout, int n) {
    return counted(layout.holes(), "hole")
        + ", "
        + counted(layout.sites(n), "site")
        + " inside and "
        + counted(layout.fixedCount(), "fixed edge");
  }

  private static String counted(int count, String what) {
    return count + " " + what + (count == 1 ? "" : "s");
  }

  private static String state(Document document, Analysis shown) {
    List<Defect> defects = shown.defects();
    if (!defects.isEmpty()) {
      String fault = defects.get(0).message();
      return document.domain() == Domain.POLYGON ? ", not simple: " + fault : ", " + fault;
    }
    return document.domain() == Domain.POLYGON ? ", simple" : "";
  }

  private static String triangulation(Document document, Analysis shown) {
    Optional<Result> result = document.result();
    return result
        .map(Result::solution)
        .or(shown::solution)
        .map(made -> ResultTitle.of(made) + ": " + counts(made))
        .orElse("not triangulated");
  }

  /** The counts and the verdict of a solution. */
  static String counts(Solution solution) {
    DegreeCount after = solution.counts();
    String counts = String.format(Locale.ROOT, "even %d, odd %d", after.even(), after.odd());
    return solution
        .countsBefore()
        .map(
            before ->
                String.format(
                    Locale.ROOT,
                    "%s; before, even %d, odd %d",
                    counts,
                    before.even(),
                    before.odd()))
        .or(() -> solution.optimum().map(best -> counts + ", " + best.verdict()))
        .orElse(counts);
  }
}
