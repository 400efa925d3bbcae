package dct.ui.edit;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Defect;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.geometry.Untangle;
import dct.core.triangulate.Domain;
import dct.render.Ink;
import dct.render.Pen;
import dct.render.Stroke;
import dct.render.Viewport;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.CommandRegistry;
import dct.ui.dialog.Failures.Remedy;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.workbench.Workbench;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** What can be done about a polygon that is not simple. */
public final class CrossingWork {
  private static final String GO = "Go to Crossing";
  private static final String UNTANGLE = "Untangle";
  private static final String USE_AS_SITES = "Use as Sites";
  private static final double MARK = 17; // the radius of the ring round the place gone to
  private static final double TICK = 9; // the lines that point at it
  private static final double WIDTH = 3;

  private final Workbench workbench;
  private final CanvasPanel canvas;
  private final Runnable shown;
  private final TouchingWork touching;
  private Optional<Defect> last = Optional.empty(); // gone to
  private Points lastOf = Points.ofPairs(); // the polygon in which it was

  /**
   * Work on the polygon of a workbench.
   *
   * @param shown is run when something else was put on the canvas
   */
  public CrossingWork(Workbench workbench, CanvasPanel canvas, Runnable shown) {
    this.workbench = workbench;
    this.canvas = canvas;
    this.shown = shown;
    touching = new TouchingWork(workbench, canvas, this::useAsSites);
    canvas.addOverlay(this::markLast);
  }

  /** What can be done about a defect of the polygon. */
  public List<Remedy> remedies() {
    return List.of(
        new Remedy("Show Me", defect -> true, this::goTo),
        new Remedy(UNTANGLE, d -> isOneRing() && !TouchingWork.isRepeated(d), defect -> untangle()),
        new Remedy(TouchingWork.SPLIT, this::canSplit, defect -> touching.split()),
        new Remedy(TouchingWork.PART, TouchingWork::isTouch, defect -> touching.part()),
        new Remedy(USE_AS_SITES, defect -> true, defect -> useAsSites()));
  }

  /** Offers the commands. */
  public void offer(CommandRegistry commands) {
    commands
        .add(
            GO,
            "ctrl G",
            "Shows where the polygon is not simple, one place after the other",
            this::goToNext)
        .enabledWhen(() -> !places().isEmpty());
    commands
        .add(
            UNTANGLE,
            "ctrl U",
            "Exchanges edges that cross until the polygon is simple; its vertices stay",
            this::untangle)
        .enabledWhen(() -> isOneRing() && !places().isEmpty());
    touching.offer(commands, this::places, this::canSplit);
    commands
        .add(
            USE_AS_SITES,
            "",
            "Takes the polygon's vertices for the sites of the other application",
            this::useAsSites)
        .enabledWhen(() -> workbench.isChosen(Domain.POLYGON) && editor().document().size() > 0);
  }

  private Editor editor() {
    return workbench.editor(Domain.POLYGON);
  }

  /** Whether there is nothing but a polygon: only its edges are exchanged or parted. */
  private boolean isOneRing() {
    return editor().document().content() == Domain.POLYGON;
  }

  /** The defects of the polygon that have a place, if it is chosen. */
  private List<Defect> places() {
    return workbench.isChosen(Domain.POLYGON)
        ? editor().shown().defects().stream().filter(CrossingWork::hasPlace).toList()
        : List.of();
  }

  private static boolean hasPlace(Defect defect) {
    return switch (defect.kind()) {
      case TOO_FEW, COLLINEAR, FEW_SITES, SITES_ON_ONE_LINE -> false;
      default -> true;
    };
  }

  /** What is wrong with the polygon, unless it is still being drawn. */
  public Optional<String> hint() {
    List<Defect> places = workbench.isDrawing() ? List.of() : places();
    return places.stream()
        .findFirst()
        .map(first -> "Not simple: " + first.fact() + "; Edit ▸ " + GO + mending(first));
  }

  private String mending(Defect defect) {
    if (TouchingWork.isTouch(defect)) {
      return (canSplit(defect) ? ", " + TouchingWork.SPLIT : "") + ", " + TouchingWork.PART;
    }
    return isOneRing() ? ", " + UNTANGLE : "; " + defect.cure();
  }

  /** Whether a polygon comes to a place again, or rings of a region meet. */
  private boolean canSplit(Defect defect) {
    return isOneRing() ? TouchingWork.isRepeated(defect) : TouchingWork.isTouch(defect);
  }

  private void goToNext() {
    List<Defect> places = places();
    int next = (last.map(places::indexOf).orElse(-1) + 1) % places.size();
    goTo(places.get(next));
    String count = places.size() == 1 ? "" : " (" + (next + 1) + " of " + places.size() + ")";
    workbench.say("Here " + places.get(next).fact() + count + "; " + places.get(next).cure());
  }

  /** Shows the place of a defect, large enough to tell its edges apart. */
  public void goTo(Defect defect) {
    last = Optional.of(defect);
    lastOf = editor().document().points();
    workbench.choose(Domain.POLYGON);
    workbench.chooseEdit();
    double x = canvas.getWidth() / 2.0;
    double y = canvas.getHeight() / 2.0;
    Viewport here = canvas.viewport().showing(defect.x(), defect.y(), x, y);
    double factor = Math.min(x, y) / 2 / (reach(defect) * here.scale());
    boolean usable = Double.isFinite(factor) && factor > 0;
    canvas.setViewport(usable ? here.zoomed(factor, x, y) : here);
  }

  /** Marks the place gone to, until the polygon changes. */
  private void markLast(Pen pen) {
    last.filter(defect -> workbench.isChosen(Domain.POLYGON))
        .filter(defect -> editor().visible().points().equals(lastOf))
        .ifPresent(defect -> mark(defect, pen));
  }

  private void mark(Defect defect, Pen pen) {
    double x = canvas.viewport().screenX(defect.x());
    double y = canvas.viewport().screenY(defect.y());
    double end = MARK + TICK;
    pen.style(Stroke.solid(Ink.HIGHLIGHT, WIDTH));
    pen.ring(x, y, MARK);
    pen.line(x - end, y, x - MARK, y);
    pen.line(x + MARK, y, x + end, y);
    pen.line(x, y - end, x, y - MARK);
    pen.line(x, y + MARK, x, y + end);
  }

  /** The distance from the place of a defect to the nearest end of its edges elsewhere. */
  private double reach(Defect defect) {
    Points points = editor().document().points();
    double nearest = Double.POSITIVE_INFINITY;
    int[] ends = {defect.first(), defect.firstEnd(), defect.second(), defect.secondEnd()};
    for (int end : ends) {
      double distance = Math.hypot(points.x(end) - defect.x(), points.y(end) - defect.y());
      nearest = distance > 0 ? Math.min(nearest, distance) : nearest;
    }
    return nearest;
  }

  private void untangle() {
    Document document = editor().document();
    workbench
        .jobs()
        .submit(
            UNTANGLE,
            progress -> untangled(document, progress),
            after -> {
              if (editor().document().equals(document)) {
                editor().perform(new Edit.Replace(UNTANGLE, document, after));
                workbench.say("The polygon is simple now; its vertices have other numbers");
              } else {
                workbench.say("The polygon has changed meanwhile; it was not untangled");
              }
            });
  }

  private static Document untangled(Document document, Progress progress) {
    int[] order = Untangle.order(document.points(), progress);
    Points points = document.points();
    Points after =
        Points.of(
            Arrays.stream(order).mapToDouble(points::x).toArray(),
            Arrays.stream(order).mapToDouble(points::y).toArray());
    Wish[] wishes = Arrays.stream(order).mapToObj(document.wishes()::wish).toArray(Wish[]::new);
    return new Document(document.domain(), after, ParityGoal.of(wishes));
  }

  private void useAsSites() {
    Document polygon = editor().document();
    Editor sites = workbench.editor(Domain.SITES);
    Document before = sites.document();
    Points points = Sites.of(polygon.points(), Progress.NONE).points(); // of some vertices, one
    boolean all = points.size() == polygon.size();
    Document after =
        all
            ? new Document(Domain.SITES, points, polygon.wishes())
            : new Document(Domain.SITES, points);
    sites.perform(new Edit.Replace(USE_AS_SITES, before, after));
    workbench.choose(Domain.SITES);
    workbench.chooseEdit();
    shown.run();
  }
}
