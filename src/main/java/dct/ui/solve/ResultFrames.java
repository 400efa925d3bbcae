package dct.ui.solve;

import dct.core.triangulate.Domain;
import dct.ui.canvas.CanvasPanel;
import dct.ui.canvas.Links;
import dct.ui.command.CommandRegistry;
import dct.ui.document.Editor;
import dct.ui.document.History;
import dct.ui.document.Result;
import dct.ui.file.FileWork;
import dct.ui.file.PictureCopy;
import dct.ui.result.Arrangement;
import dct.ui.result.ResultView;
import dct.ui.result.ViewArea;
import dct.ui.result.ViewHost;
import dct.ui.workbench.Workbench;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.JFrame;

/**
 * The results of the polygon, each in a view of its own, as the history has them: a view is closed
 * when its result is undone, and opened again when that is redone. They are shown in frames of
 * their own or within the window.
 */
public final class ResultFrames {
  private final Workbench workbench;
  private final CanvasPanel canvas;
  private final Links links;
  private final FrameHost frames;
  private final ViewArea area;
  private final FileWork files;
  private ViewHost host;
  private Consumer<CommandRegistry> more = commands -> {};
  private final List<ResultView> all = new ArrayList<>(); // also those of earlier documents
  private final Map<ResultView, ResultFlips> flips = new HashMap<>(); // of each of them
  private final Map<Integer, ResultView> views = new HashMap<>(); // by the number of the view
  private final Set<Integer> undone = new HashSet<>(); // views that are closed for now
  private final Set<Integer> closed = new HashSet<>(); // by the user
  private History history; // of the document that the views belong to
  private Optional<ResultView> latest = Optional.empty(); // of the result shown last

  /**
   * Views of a window; none is open yet.
   *
   * @param canvas whose labels new views have
   * @param links between the canvas and the views
   * @param area where views are shown within the window
   * @param files saves the documents
   */
  public ResultFrames(
      Workbench workbench,
      JFrame owner,
      CanvasPanel canvas,
      Links links,
      ViewArea area,
      FileWork files) {
    this.files = files;
    this.workbench = workbench;
    this.canvas = canvas;
    this.links = links;
    this.area = area;
    frames = new FrameHost(owner, canvas);
    host = frames;
    history = editor().history();
  }

  private Editor editor() {
    return workbench.editor(Domain.POLYGON);
  }

  /** Says what offers each view more commands than its own. */
  void setCommands(Consumer<CommandRegistry> offer) {
    more = offer;
  }

  /** Brings the commands of all views up to date. */
  void refreshCommands() {
    all.forEach(view -> view.commands().refresh());
  }

  /** Whether views are shown within the window. */
  public boolean isInWindow() {
    return host == area;
  }

  /** How views share the window with the drawing. */
  public Arrangement arrangement() {
    return area.arrangement();
  }

  /** Lets views share the window with the drawing in another way. */
  public void arrange(Arrangement arrangement) {
    area.setArrangement(arrangement);
  }

  /** Whether the view in use within the window can be moved by so many places. */
  boolean canMove(int places) {
    return area.canMove(places);
  }

  /** Moves the view in use within the window by so many places. */
  void move(int places) {
    area.move(places);
  }

  /** Shows views within the window, or in frames of their own; those that are open, too. */
  public void setInWindow(boolean within) {
    if (within != isInWindow()) {
      ViewHost before = host;
      host = within ? area : frames;
      for (ResultView view : all) {
        boolean shown = before.isShown(view);
        before.release(view);
        if (shown) {
          host.show(view, Optional.empty());
        }
      }
    }
  }

  /** Brings the views up to date with the history. */
  public void refresh() {
    if (editor().history() != history) {
      history = editor().history();
      views.clear(); // those of the document before stay as they are
      undone.clear();
      closed.clear();
      latest = Optional.empty();
    }
    Map<Integer, Result> results = history.results();
    closed.retainAll(results.keySet());
    views.forEach(
        (number, view) -> refresh(number, view, Optional.ofNullable(results.get(number))));
    Optional<Result> present = history.present().result();
    present
        .filter(result -> !views.containsKey(result.view()) && !closed.contains(result.view()))
        .ifPresent(this::open);
    latest = present.map(result -> views.get(result.view()));
    views.values().forEach(view -> view.setDocument(editor().name()));
    flips.values().forEach(ResultFlips::refresh);
  }

  private void refresh(int number, ResultView view, Optional<Result> result) {
    if (result.isPresent()) {
      view.show(result.get());
      if (undone.remove(number)) {
        host.show(view, Optional.empty());
      }
    } else if (host.isShown(view)) {
      undone.add(number);
      host.hide(view);
    }
  }

  private void open(Result result) {
    // What was flipped is shown beside what it was before, so that they can be compared.
    Optional<ResultView> before =
        latest.filter(view -> host.isShown(view) && result.solution().flips().isPresent());
    ResultView view = viewOf(result, editor().name());
    views.put(result.view(), view);
    view.whenClosed(() -> close(result.view(), view));
    host.show(view, before);
  }

  private ResultView viewOf(Result result, String name) {
    ResultView view = new ResultView(result, name, canvas.labels(), links);
    prepare(view);
    return view;
  }

  /** Opens a view of pieces of a polygon, which are no part of the history either. */
  public void show(PieceWork.Pieces pieces) {
    ResultView view =
        new ResultView(pieces.title(), pieces.name(), pieces.scene(), canvas.labels(), links);
    prepare(view);
    show(view);
  }

  private boolean isOfHistory(ResultView view) {
    return views.containsValue(view);
  }

  private void prepare(ResultView view) {
    ResultFlips flipping = new ResultFlips(view, workbench, () -> isOfHistory(view), files::folder);
    flips.put(view, flipping);
    ResultCommands.offer(view, workbench.jobs(), flipping::say, FrameHost::shown);
    ResultCommands.offerSaving(view, files, flipping::say);
    PictureCopy.offer(view.commands(), view.canvas(), workbench.jobs(), flipping::say);
    more.accept(view.commands());
    all.add(view);
  }

  private void close(int number, ResultView view) {
    if (views.remove(number, view)) {
      closed.add(number);
    }
    close(view);
  }

  private void close(ResultView view) {
    all.remove(view);
    flips.remove(view);
    host.release(view);
  }

  /** Opens a view of a result that is no part of the history. */
  public void showLate(ResultWork.Late late) {
    show(viewOf(late.result(), late.name()));
  }

  private void show(ResultView view) {
    view.whenClosed(() -> close(view));
    host.show(view, Optional.empty());
  }

  /** Opens views of something else than results, which belong together. */
  public void open(List<ResultView> pictures) {
    for (ResultView view : pictures) {
      prepare(view);
      view.whenClosed(() -> close(view));
    }
    host.showAll(pictures);
  }

  /** Brings all views that are shown to the front; whether there are any. */
  boolean bringForward() {
    List<ResultView> shown = all.stream().filter(host::isShown).toList();
    shown.forEach(host::toFront);
    return !shown.isEmpty();
  }

  /** Brings the view of a result to the front; opens one if there is none. */
  void bringForward(Result result) {
    Optional<ResultView> shown =
        all.stream()
            .filter(view -> host.isShown(view) && view.result().equals(Optional.of(result)))
            .findFirst();
    if (shown.isPresent()) {
      host.toFront(shown.get());
    } else if (closed.remove(result.view())) {
      open(result);
    } else {
      showLate(new ResultWork.Late(result, workbench.active().map(Editor::name).orElse("")));
    }
  }

  /** Closes all views. */
  public void dispose() {
    all.forEach(host::release);
  }
}
