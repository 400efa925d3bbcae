package dct.ui.solve;

import dct.core.Progress;
import dct.core.degree.ConvexPieces;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Domain;
import dct.core.triangulate.MonotonePartition;
import dct.core.triangulate.Partition;
import dct.render.Scene;
import dct.ui.command.CommandRegistry;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import dct.ui.workbench.Workbench;
import java.util.function.Consumer;

/** The pieces that the thesis's methods cut a polygon into, without the triangulation of each. */
public final class PieceWork {
  private final Workbench workbench;
  private final Consumer<Pieces> show;

  /**
   * A picture of pieces.
   *
   * @param title what was done
   * @param name of the polygon
   * @param scene the polygon and the edges between the pieces
   */
  public record Pieces(String title, String name, Scene scene) {}

  /** The ways to cut a polygon. */
  private enum Kind {
    CONVEX("Convex Partition", "Shows the convex pieces of the polygon, by Hertel and Mehlhorn"),
    MONOTONE("Monotone Partition", "Shows the monotone pieces of the polygon, by Algorithm 2.2");

    private final String title;
    private final String description;

    Kind(String title, String description) {
      this.title = title;
      this.description = description;
    }

    Partition cut(Region region, Progress progress) {
      return switch (this) {
        case CONVEX -> ConvexPieces.of(region, progress);
        case MONOTONE -> MonotonePartition.partition(region, progress);
      };
    }
  }

  private PieceWork(Workbench workbench, Consumer<Pieces> show) {
    this.workbench = workbench;
    this.show = show;
  }

  /**
   * Offers a command for each way.
   *
   * @param show opens a picture beside the window
   */
  public static void offer(CommandRegistry commands, Workbench workbench, Consumer<Pieces> show) {
    PieceWork work = new PieceWork(workbench, show);
    for (Kind kind : Kind.values()) {
      commands
          .add(kind.title, "", kind.description, () -> work.cut(kind))
          .enabledWhen(() -> workbench.isChosen(Domain.POLYGON));
    }
  }

  private void cut(Kind kind) {
    Editor editor = workbench.editor(Domain.POLYGON);
    Document document = editor.document();
    String name = editor.name();
    workbench
        .jobs()
        .submit(
            kind.title,
            progress -> Scene.of(kind.cut(region(document, progress), progress)),
            scene -> show.accept(new Pieces(kind.title, name, scene)));
  }

  private static Region region(Document document, Progress progress) {
    return document.content() == Domain.REGION
        ? Region.of(document.rings(), progress)
        : Region.of(SimplePolygon.of(document.points(), progress));
  }
}
