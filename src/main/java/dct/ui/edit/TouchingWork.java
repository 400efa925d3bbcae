package dct.ui.edit;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Defect;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
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
import dct.ui.document.Layout;
import dct.ui.workbench.Workbench;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.IntStream;
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

  /**
   * Offers the commands.
   *
   * @param canSplit at which defects a polygon may fall apart
   */
  void offer(CommandRegistry commands, Supplier<List<Defect>> places, Predicate<Defect> canSplit) {
    commands
        .add(
            SPLIT,
            "",
            "Takes one of the rings into which the polygon falls apart where it meets itself",
            this::split)
        .enabledWhen(() -> places.get().stream().anyMatch(canSplit));
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

  /** Asks which part is meant, with a picture of each, and takes that. */
  void split() {
    Document document = editor().document();
    workbench
        .jobs()
        .submit(
            "Splitting the ring",
            progress -> parts(document, progress),
            parts -> SwingUtilities.invokeLater(() -> choose(document, parts)));
  }

  /** What a document falls apart into: the rings of a polygon, else parts with their holes. */
  private static List<Document> parts(Document document, Progress progress) {
    if (document.content() == Domain.POLYGON) {
      return Touching.rings(document.points(), progress).stream()
          .map(ring -> part(document, Rings.ofChain(picked(document.points(), ring)), ring))
          .toList();
    }
    return Touching.pieces(document.rings(), progress).orElse(List.of()).stream()
        .map(piece -> part(document, piece.toRings(document.points()), piece.vertices()))
        .toList();
  }

  private static Document part(Document document, Rings rings, int... vertices) {
    Wish[] wishes = Arrays.stream(vertices).mapToObj(document.wishes()::wish).toArray(Wish[]::new);
    return new Document(Domain.POLYGON, rings.points(), Layout.of(rings), ParityGoal.of(wishes));
  }

  private void choose(Document document, List<Document> parts) {
    if (parts.isEmpty()) {
      workbench.say("There is no ring in it that could be taken apart; " + PART + " may do");
    } else if (parts.size() == 1) {
      take(document, parts.get(0));
    } else {
      List<Shape> shapes = parts.stream().map(TouchingWork::shape).toList();
      Shapes all = new Shapes("ring that meets itself", shapes, List.of());
      SeveralShapes several = new SeveralShapes(editor().name(), all);
      WhatIsMeant.ask(SwingUtilities.getWindowAncestor(canvas), "Split Ring", several, Choice.NONE)
          .ifPresent(choice -> take(document, parts, choice));
    }
  }

  private static Shape shape(Document part) {
    int[] outer = part.rings().ring(0);
    Points points = picked(part.points(), outer);
    return new Shape(Shape.Kind.RING, "", points, new int[outer.length], Optional.empty());
  }

  private static Points picked(Points points, int... ring) {
    return Points.of(
        Arrays.stream(ring).mapToDouble(points::x).toArray(),
        Arrays.stream(ring).mapToDouble(points::y).toArray());
  }

  private void take(Document document, List<Document> parts, Choice choice) {
    if (choice.as().isPresent()) {
      useAsSites.run();
    } else {
      take(document, parts.get(choice.pick().orElseThrow() - 1));
    }
  }

  private void take(Document document, Document part) {
    String what = part.content() == Domain.POLYGON ? "ring" : "part";
    String said = "The polygon is the " + what + " of " + part.size() + " vertices now";
    replace("Split Ring", document, part, said);
  }

  /** Moves vertices until the polygon is simple, or says that this cannot be done. */
  void part() {
    Document document = editor().document();
    workbench
        .jobs()
        .submit(
            PART,
            progress -> Touching.parted(document.rings(), progress),
            parted ->
                parted.ifPresentOrElse(
                    rings -> takeParted(document, rings),
                    () -> workbench.say("No hair parts it; move or delete what crosses")));
  }

  private void takeParted(Document document, Rings parted) {
    Points before = document.points();
    Points after = parted.points();
    long moved =
        IntStream.range(0, before.size())
            .filter(v -> before.x(v) != after.x(v) || before.y(v) != after.y(v))
            .count();
    Document made = new Document(Domain.POLYGON, after, Layout.of(parted), document.wishes());
    replace(PART, document, made, "The polygon is simple now; " + moved + " vertices moved a hair");
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
