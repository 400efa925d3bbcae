package dct.ui.solve;

import dct.core.triangulate.Domain;
import dct.problem.Method;
import dct.ui.command.CommandRegistry;
import dct.ui.document.MostVertices;
import dct.ui.document.ResultTitle;
import dct.ui.edit.WishWork;
import dct.ui.workbench.Workbench;
import java.util.Map;

/** The commands that make results of the document. */
public final class TriangulateCommands {
  private static final Map<Method, String> KEYS =
      Map.of(
          Method.CONVEX_EVEN, "shift E",
          Method.CONVEX_ODD, "shift O",
          Method.MONOTONE, "shift M",
          Method.EAR_CLIPPING, "shift C");

  private final Workbench workbench;
  private final ResultWork results;

  private TriangulateCommands(Workbench workbench, ResultWork results) {
    this.workbench = workbench;
    this.results = results;
  }

  /** Offers the commands for the documents of the workbench. */
  public static void offer(
      CommandRegistry commands, Workbench workbench, ResultWork results, WishWork wishes) {
    TriangulateCommands offered = new TriangulateCommands(workbench, results);
    offered.offerMethods(commands);
    offered.offerImprovements(commands, wishes);
  }

  private void offerMethods(CommandRegistry commands) {
    for (Method method : Method.of(Domain.POLYGON)) {
      commands
          .add(
              method.title(),
              KEYS.getOrDefault(method, ""),
              method.description(),
              () -> results.triangulate(method))
          .enabledWhen(() -> workbench.isChosen(Domain.POLYGON));
    }
    offerReturn(commands, "Delaunay", "Goes back to the Delaunay triangulation", Domain.SITES);
    offerReturn(commands, "None", "Goes back to the polygon alone", Domain.POLYGON);
  }

  private void offerReturn(
      CommandRegistry commands, String name, String description, Domain domain) {
    commands
        .add(name, "", description, () -> results.dropResult(name))
        .enabledWhen(() -> workbench.isChosen(domain) && results.hasResult());
  }

  private void offerImprovements(CommandRegistry commands, WishWork wishes) {
    commands
        .add(
            ResultTitle.FLIP,
            "shift F",
            "Flips diagonals so that more vertices are even",
            results::flip)
        .enabledWhen(() -> workbench.domain().isPresent());
    for (MostVertices most : MostVertices.values()) {
      commands
          .add(
              most.title(),
              most.key(),
              most.description(),
              () -> results.optimize(most.title(), most::goal))
          .enabledWhen(() -> workbench.domain().isPresent());
    }
    commands
        .add(
            "Wished Parities…",
            "ctrl shift W",
            "Finds the triangulation that grants the most wishes",
            () -> wishes.ask(results::optimize))
        .enabledWhen(() -> workbench.domain().isPresent());
  }
}
