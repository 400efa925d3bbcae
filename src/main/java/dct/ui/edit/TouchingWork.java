package dct.ui.edit;

import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Defect;
import dct.core.geometry.Points;
import dct.core.geometry.Touching;
import dct.core.triangulate.Domain;
import dct.io.format.Choice;
import dct.io.format.SeveralShapes;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.CommandRegistry;
import dct.ui.dialog.WhatIsMeant;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.workbench.Workbench;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;

/** What can be done about a polygon that meets itself: both are steps that can be undone. */
final class TouchingWork {
  static final String SPLIT = "Split Ring…";
  static final String PART = "Part by a Hair";

  private final Workbench workbench;
  private final CanvasPanel canvas;
  private final Runnable useAsSites;

  /** Work on the polygon of a workbench. */
  TouchingWork(Workbench workbench, CanvasPanel canvas, Runnable useAsSites) {
    this.workbench = workbench;
    this.canvas = canvas;
    this.useAsSites = useAsSites;
  }

  /** Offers the commands. */
  void offer(CommandRegistry commands, Supplier<List<Defect>> places) {
    commands
        .add(
            SPLIT,
            "",
            "Takes one of the rings into which the polygon falls apart where it meets itself",
            this::split)
        .enabledWhen(() -> places.get().stream().anyMatch(TouchingWork::isRepeated));
    commands
        .add(
            PART,
            "",
            "Moves vertices a hair where the polygon meets itself, so that it is simple",
            this::part)
        .enabledWhen(() -> places.get().stream().anyMatch(TouchingWork::isTouch));
  }

  /** Whether the polygon comes to a place again. */
  static boolean isRepeated(Defect defect) {
    return defect.kind() == Defect.Kind.DUPLICATE;
  }

  /** Whether the polygon meets itself, but does not cross itself. */
  static boolean isTouch(Defect defect) {
    return switch (defect.kind()) {
      case DUPLICATE, TOUCH, OVERLAP -> true;
      default -> false;
    };
  }

  private Editor editor() {
    return workbench.editor(Domain.POLYGON);
  }

  /** Asks which ring is meant, with a picture of each, and takes that. */
  void split() {
    Document document = editor().document();
    workbench
        .jobs()
        .submit(
            "Splitting the ring",
            progress -> Touching.rings(document.points(), progress),
            rings -> SwingUtilities.invokeLater(() -> choose(document, rings)));
  }

  private void choose(Document document, List<int[]> rings) {
    if (rings.isEmpty()) {
      workbench.say("The polygon only goes to and fro; there is no ring in it");
    } else if (rings.size() == 1) {
      take(document, rings.get(0));
    } else {
      List<Shape> shapes = rings.stream().map(ring -> shape(document.points(), ring)).toList();
      Shapes all = new Shapes("ring that meets itself", shapes, List.of());
      SeveralShapes several = new SeveralShapes(editor().name(), all);
      WhatIsMeant.ask(SwingUtilities.getWindowAncestor(canvas), "Split Ring", several, Choice.NONE)
          .ifPresent(choice -> take(document, rings, choice));
    }
  }

  private static Shape shape(Points points, int[] ring) {
    return new Shape(
        Shape.Kind.RING, "", picked(points, ring), new int[ring.length], Optional.empty());
  }

  private static Points picked(Points points, int[] ring) {
    return Points.of(
        Arrays.stream(ring).mapToDouble(points::x).toArray(),
        Arrays.stream(ring).mapToDouble(points::y).toArray());
  }

  private void take(Document document, List<int[]> rings, Choice choice) {
    if (choice.as().isPresent()) {
      useAsSites.run();
    } else {
      take(document, rings.get(choice.pick().orElseThrow() - 1));
    }
  }

  private void take(Document document, int[] ring) {
    Wish[] wishes = Arrays.stream(ring).mapToObj(document.wishes()::wish).toArray(Wish[]::new);
    Points points = picked(document.points(), ring);
    Document after = new Document(Domain.POLYGON, points, ParityGoal.of(wishes));
    String said = "The polygon is the ring of " + ring.length + " vertices now";
    replace("Split Ring", document, after, said);
  }

  /** Moves vertices until the polygon is simple, or says that this cannot be done. */
  void part() {
    Document document = editor().document();
    workbench
        .jobs()
        .submit(
            PART,
            progress -> Touching.parted(document.points(), progress),
            parted ->
                parted.ifPresentOrElse(
                    points -> take(document, points),
                    () -> workbench.say("No hair parts it, since edges cross; Untangle does")));
  }

  private void take(Document document, Points parted) {
    Points before = document.points();
    long moved = 0;
    for (int v = 0; v < before.size(); v++) {
      boolean same = before.x(v) == parted.x(v) && before.y(v) == parted.y(v);
      moved += same ? 0 : 1;
    }
    Document after = new Document(Domain.POLYGON, parted, document.wishes());
    replace(
        PART, document, after, "The polygon is simple now; " + moved + " vertices moved a hair");
  }

  private void replace(String label, Document before, Document after, String said) {
    if (editor().document().equals(before)) {
      editor().perform(new Edit.Replace(label, before, after));
      workbench.say(said);
    } else {
      workbench.say("The polygon has changed meanwhile; nothing was done");
    }
  }
}
