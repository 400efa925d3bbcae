package dct.ui.workbench;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.problem.Solution;
import dct.render.Viewport;
import dct.ui.document.Analysis;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.document.Result;
import dct.ui.document.Selection;
import dct.ui.flip.FlipDesk;
import dct.ui.job.Jobs;
import dct.ui.tool.DeleteTool;
import dct.ui.tool.DrawTool;
import dct.ui.tool.EditTool;
import dct.ui.tool.FixTool;
import dct.ui.tool.FlipTool;
import dct.ui.tool.SiteTool;
import dct.ui.tool.Snap;
import dct.ui.tool.SplitTool;
import dct.ui.tool.Tool;
import dct.ui.tool.ToolContext;
import dct.ui.tool.WishTool;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;

/**
 * The state of a main window: the two applications' editors, which of them is chosen, and the tool.
 * Each application keeps its document while the other is shown. Lives on the event thread.
 */
public final class Workbench implements ToolContext {
  private final Jobs jobs = new Jobs();
  private final Map<Domain, Editor> editors = new EnumMap<>(Domain.class);
  private final Snap snap = new Snap(this::changed);
  private final Tool draw = new DrawTool();
  private final Tool edit = new EditTool();
  private final Tool wish = new WishTool();
  private final Tool site = new SiteTool();
  private final Tool fix = new FixTool();
  private boolean showsBound;
  private final FlipDesk flips;
  private final Tool flip;
  private final List<Tool> boxes = List.of(draw, new DeleteTool(), edit, new SplitTool());
  private final List<Runnable> listeners = new ArrayList<>();
  private final Supplier<Viewport> viewport;
  private final Consumer<String> status;
  private Optional<Domain> domain = Optional.empty();
  private Tool tool = draw;

  /**
   * A workbench on which no application is chosen yet.
   *
   * @param viewport where the model is on the screen
   * @param status takes messages for the status line
   */
  public Workbench(Supplier<Viewport> viewport, Consumer<String> status) {
    this.viewport = viewport;
    this.status = status;
    for (Domain each : Domain.applications()) {
      Editor editor = new Editor(each, jobs);
      editors.put(each, editor);
      editor.setGrowing(true);
      editor.addListener(this::changed);
    }
    SiteFlips sites = new SiteFlips(editor(Domain.SITES), () -> isChosen(Domain.SITES));
    flips = new FlipDesk(sites, jobs, status);
    flip = new FlipTool(flips);
  }

  /** Calls the listener after each change of anything here. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** The background jobs of this window. */
  public Jobs jobs() {
    return jobs;
  }

  /** Which application is chosen; none at the start. */
  public Optional<Domain> domain() {
    return domain;
  }

  /** Whether this application is chosen. */
  public boolean isChosen(Domain of) {
    return domain.filter(of::equals).isPresent();
  }

  /** Chooses an application. */
  public void choose(Domain chosen) {
    if (domain.filter(chosen::equals).isEmpty()) {
      leaveTool();
      domain = Optional.of(chosen);
      if (!tool.isFor(chosen)) {
        choose(edit);
      }
      changed();
    }
  }

  /** The flips of the sites in the canvas. */
  public FlipDesk flips() {
    return flips;
  }

  /** The chosen application's editor. */
  public Optional<Editor> active() {
    return domain.map(editors::get);
  }

  /** The editor of this application. */
  public Editor editor(Domain of) {
    return editors.get(of);
  }

  /** The thesis's tools, in the order of their checkboxes. */
  public List<Tool> boxes() {
    return boxes;
  }

  /** All tools, in the order of the menu. */
  public List<Tool> tools() {
    return Stream.concat(boxes.stream(), Stream.of(site, fix, wish, flip)).toList();
  }

  /** The chosen tool, in an application. */
  public Optional<Tool> tool() {
    return domain.map(chosen -> tool);
  }

  /** Whether a click draws a vertex. */
  public boolean isDrawing() {
    return tool().filter(draw::equals).isPresent();
  }

  /** Chooses a tool. */
  public void choose(Tool chosen) {
    leaveTool();
    tool = chosen;
    if (chosen == draw) {
      active().ifPresent(editor -> editor.select(Selection.NONE));
    }
    editors.values().forEach(editor -> editor.setGrowing(chosen == draw));
  }

  /** Chooses Draw Vertex. */
  public void chooseDraw() {
    choose(draw);
  }

  @Override
  public void chooseEdit() {
    choose(edit);
  }

  private void leaveTool() {
    if (domain.isPresent()) {
      tool.cancelled(this);
      tool.left(this);
    }
  }

  /** What the next click will do. */
  public String hint() {
    return tool().map(t -> t.hint(this)).orElse("Choose Polygon Based or Point Sites Based");
  }

  /**
   * The triangulation of the document that is shown: the result of the polygon, or what is in the
   * canvas of the sites; nothing while that is still being computed.
   */
  public Optional<Solution> solution() {
    return active()
        .flatMap(
            editor ->
                editor.domain() == Domain.POLYGON
                    ? editor.document().result().map(Result::solution)
                    : editor.shown().solution().filter(s -> isUpToDate(editor)));
  }

  private static boolean isUpToDate(Editor editor) {
    return editor.shown().document().equals(editor.document());
  }

  /** Whether the bound is shown beside the counts. */
  public boolean showsBound() {
    return showsBound;
  }

  /** Shows the bound beside the counts, or no longer. */
  public void setShowsBound(boolean shows) {
    showsBound = shows;
    changed();
  }

  /** What the canvas shows, if that is a triangulation of the points as they are in the picture. */
  public Optional<Solution> inCanvas() {
    return active()
        .filter(e -> e.shown().document().isDrawnAs(e.visible()))
        .flatMap(e -> onTheWay(e).or(() -> e.shown().solution()));
  }

  private Optional<Solution> onTheWay(Editor editor) {
    return editor.domain() == Domain.SITES && flips.onTheWay().isPresent()
        ? flips.solution()
        : Optional.empty();
  }

  private void changed() {
    listeners.forEach(Runnable::run);
  }

  private Editor present() {
    return active().orElseThrow(() -> new IllegalStateException("no application is chosen"));
  }

  @Override
  public Document document() {
    return present().document();
  }

  @Override
  public Analysis shown() {
    return present().shown();
  }

  @Override
  public Viewport viewport() {
    return viewport.get();
  }

  @Override
  public void perform(Edit change) {
    present().perform(change);
  }

  @Override
  public void preview(Points points) {
    present().preview(points);
  }

  @Override
  public void endPreview() {
    present().endPreview();
  }

  @Override
  public Selection selection() {
    return present().selection();
  }

  @Override
  public void select(Selection others) {
    present().select(others);
  }

  @Override
  public Snap snap() {
    return snap;
  }

  @Override
  public void say(String message) {
    status.accept(message);
  }
}
