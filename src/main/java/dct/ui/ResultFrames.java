package dct.ui;

import dct.core.triangulate.Domain;
import dct.render.Labels;
import dct.ui.document.Editor;
import dct.ui.document.History;
import dct.ui.document.Result;
import dct.ui.result.ResultView;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import javax.swing.JFrame;

/**
 * The results of the polygon, each in a frame of its own, as the history has them: a frame is
 * closed when its result is undone, and opened again when that is redone.
 */
final class ResultFrames {
  private final Workbench workbench;
  private final JFrame owner;
  private final Supplier<Labels> labels;
  private final Supplier<Optional<Path>> folder;
  private final List<ResultFrame> all = new ArrayList<>(); // also those of earlier documents
  private final List<ResultFlips> flips = new ArrayList<>(); // one for each of them
  private final Map<Integer, ResultFrame> frames = new HashMap<>(); // by view
  private final Set<Integer> undone = new HashSet<>(); // views that are closed for now
  private History history; // of the document that the frames belong to
  private Optional<ResultFrame> latest = Optional.empty(); // of the result shown last

  /**
   * Frames of a window; none is open yet.
   *
   * @param labels what new frames write beside the vertices
   * @param folder where the document's file is
   */
  ResultFrames(
      Workbench workbench, JFrame owner, Supplier<Labels> labels, Supplier<Optional<Path>> folder) {
    this.folder = folder;
    this.workbench = workbench;
    this.owner = owner;
    this.labels = labels;
    history = editor().history();
  }

  private Editor editor() {
    return workbench.editor(Domain.POLYGON);
  }

  /** Brings the frames up to date with the history. */
  void refresh() {
    if (editor().history() != history) {
      history = editor().history();
      frames.clear(); // those of the document before stay as they are
      undone.clear();
      latest = Optional.empty();
    }
    Map<Integer, Result> results = history.results();
    frames.forEach((view, frame) -> refresh(view, frame, Optional.ofNullable(results.get(view))));
    Optional<Result> present = history.present().result();
    present.filter(result -> !frames.containsKey(result.view())).ifPresent(this::open);
    latest = present.map(result -> frames.get(result.view()));
    flips.forEach(ResultFlips::refresh);
  }

  private void refresh(int view, ResultFrame frame, Optional<Result> result) {
    if (result.isPresent()) {
      frame.view().show(result.get());
      if (undone.remove(view)) {
        frame.setVisible(true);
      }
    } else if (frame.isVisible()) {
      undone.add(view);
      frame.setVisible(false);
    }
  }

  private void open(Result result) {
    // What was flipped is shown beside what it was before, so that they can be compared.
    Optional<ResultFrame> before =
        latest.filter(frame -> frame.isShowing() && result.solution().flips().isPresent());
    ResultFrame frame = show(result, editor().name(), before);
    before.ifPresent(JFrame::toFront);
    frames.put(result.view(), frame);
  }

  /** Opens a frame that is no part of the history. */
  void showLate(ResultWork.Late late) {
    show(late.result(), late.name(), Optional.empty());
  }

  /** Opens a frame with pieces of a polygon, which are no part of the history either. */
  void show(PieceWork.Pieces pieces) {
    ResultView view = new ResultView(pieces.title(), pieces.name(), pieces.scene(), labels.get());
    show(view, Optional.empty());
  }

  private ResultFrame show(Result result, String name, Optional<ResultFrame> beside) {
    return show(new ResultView(result, name, labels.get()), beside);
  }

  private ResultFrame show(ResultView view, Optional<ResultFrame> beside) {
    ResultCommands.offer(view, workbench.jobs());
    flips.add(new ResultFlips(view, workbench, () -> isOfHistory(view), folder));
    ResultFrame frame = new ResultFrame(view);
    JFrame other = beside.isPresent() ? beside.get() : owner;
    Placement.beside(frame, other, owner, all.size());
    all.add(frame);
    frame.setVisible(true);
    return frame;
  }

  private boolean isOfHistory(ResultView view) {
    return frames.values().stream().anyMatch(frame -> frame.view() == view);
  }

  /** Closes all frames. */
  void dispose() {
    all.forEach(JFrame::dispose);
  }
}
