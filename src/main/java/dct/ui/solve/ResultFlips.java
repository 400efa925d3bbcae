package dct.ui.solve;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.problem.Solution;
import dct.render.Viewport;
import dct.ui.canvas.ToolMouse;
import dct.ui.document.Analysis;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.document.Result;
import dct.ui.edit.EditCommands;
import dct.ui.explain.BoundNote;
import dct.ui.flip.FlipCommands;
import dct.ui.flip.FlipDesk;
import dct.ui.flip.FlipSource;
import dct.ui.result.HintText;
import dct.ui.result.ResultView;
import dct.ui.tool.FlipTool;
import dct.ui.tool.ToolContext;
import dct.ui.workbench.Workbench;
import java.awt.BorderLayout;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JPanel;

/**
 * Lets the edges of a polygon's result be flipped in a view of its own, as long as its points are
 * the document's.
 */
public final class ResultFlips implements FlipSource, ToolContext {
  private final ResultView view;
  private final Editor editor;
  private final BooleanSupplier current;
  private final HintText status = new HintText();
  private final FlipDesk desk;
  private final FlipTool tool;
  private final FlipCommands commands;
  private final BoundNote bound;

  /**
   * Flips in a view.
   *
   * @param current whether the view belongs to the history of the document
   * @param folder where the document's file is
   */
  ResultFlips(
      ResultView view,
      Workbench workbench,
      BooleanSupplier current,
      Supplier<Optional<Path>> folder) {
    this.view = view;
    this.current = current;
    editor = workbench.editor(domain().map(Domain::application).orElse(Domain.POLYGON));
    desk = new FlipDesk(this, workbench.jobs(), this::say);
    tool = new FlipTool(desk);
    commands =
        FlipCommands.offer(
            view.commands(),
            desk,
            new FlipListWork(view, desk, workbench.jobs(), folder),
            view.canvas(),
            () -> true);
    bound =
        new BoundNote(view.canvas(), workbench.jobs(), workbench::showsBound, this::shownSolution);
    EditCommands.offerHistory(view.commands(), () -> domain().map(any -> editor));
    new ToolMouse(view.canvas(), () -> Optional.of(tool), this, spot -> hint());
    view.canvas().setCursor(tool.cursor());
    layOut();
    desk.addListener(this::shownChanged);
    refresh();
  }

  private void layOut() {
    HintText aside = new HintText();
    aside.setName("aside");
    aside.setVisible(false);
    view.canvas()
        .setAside(
            words -> {
              aside.say(words);
              aside.setVisible(!words.isEmpty());
            });
    JPanel line = new JPanel(new BorderLayout(12, 0));
    line.setBorder(BorderFactory.createEmptyBorder(5, 12, 5, 12));
    line.add(status, BorderLayout.CENTER);
    line.add(aside, BorderLayout.NORTH);
    JPanel below = new JPanel(new BorderLayout());
    below.add(commands.panel(), BorderLayout.CENTER);
    below.add(line, BorderLayout.SOUTH);
    view.addBelow(below);
  }

  /** What the result is of; nothing for a picture, which has no history. */
  private Optional<Domain> domain() {
    return view.result().map(result -> result.solution().instance().domain());
  }

  /** What the view shows, also where its points are no longer the document's. */
  private Optional<Solution> shownSolution() {
    return desk.solution().or(() -> view.result().map(Result::solution));
  }

  /** Brings everything up to date with the document and the view. */
  void refresh() {
    commands.refresh();
    bound.refresh();
    view.commands().refresh();
    hint();
  }

  private void shownChanged() {
    view.showState(desk.onTheWay());
    bound.refresh();
    view.commands().refresh();
    hint();
  }

  private void hint() {
    say(tool.hint(this));
  }

  // ---- where the flips come from and go to

  @Override
  public Optional<Result> result() {
    boolean same = current.getAsBoolean() && isOf(editor.document());
    return same ? view.result() : Optional.empty();
  }

  private boolean isOf(Document document) {
    return view.result().filter(result -> document.isOf(result.solution().instance())).isPresent();
  }

  @Override
  public String refusal() {
    Optional<Domain> domain = domain();
    if (domain.isEmpty()) {
      return "A picture to look at: edges are flipped in the views of results";
    }
    return switch (domain.get()) {
      case POLYGON, REGION ->
          "The polygon is no longer the one of this result: undo the change, or triangulate again";
      case SITES -> "A result to look at: edges of sites are flipped in the main window";
    };
  }

  @Override
  public Editor editor() {
    return editor;
  }

  // ---- what the tool may know and do

  @Override
  public Document document() {
    return editor.document();
  }

  @Override
  public Analysis shown() {
    return editor.shown();
  }

  @Override
  public Viewport viewport() {
    return view.canvas().viewport();
  }

  @Override
  public void perform(Edit edit) {
    editor.perform(edit);
  }

  @Override
  public void preview(Points points) {
    editor.preview(points);
  }

  @Override
  public void endPreview() {
    editor.endPreview();
  }

  /** There is no other tool in this view. */
  @Override
  public void chooseEdit() {}

  @Override
  public void say(String message) {
    status.say(message);
  }
}
