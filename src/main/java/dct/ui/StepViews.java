package dct.ui;

import dct.render.Viewport;
import dct.ui.canvas.CanvasPanel;
import dct.ui.document.Edit;
import dct.ui.document.History;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.WeakHashMap;

/**
 * Lets the view go with the steps of a history. Where a step showed another part of the plane, as
 * Random Sites does, its undo shows again what was shown before, and its redo what it showed. After
 * any other undo or redo the view stays as it is, unless nothing of the drawing would be in sight.
 */
final class StepViews {
  private final CanvasPanel canvas;
  private final Map<History, Map<Edit, Viewport>> before = new WeakHashMap<>(); // by the step
  private History last;
  private Edit undone; // last in it; null if none is

  /** Lets the view of a canvas go with the steps. */
  StepViews(CanvasPanel canvas) {
    this.canvas = canvas;
  }

  /** Shows the drawing well, as a part of the step that was done last. */
  void refit(History history) {
    Viewport was = canvas.viewport();
    canvas.showWell();
    history
        .lastDone()
        .ifPresent(
            step -> before.computeIfAbsent(history, h -> new IdentityHashMap<>()).put(step, was));
  }

  /** Sees whether a step was taken back or done again in the history that is shown. */
  @SuppressWarnings("ReferenceEquality") // equal steps may be different ones
  void follow(History history) {
    Edit now = history.lastUndone().orElse(null);
    if (history == last && now != undone) {
      if (undone != null && history.lastDone().orElse(null) == undone) {
        doneAgain(undone);
      } else if (now != null) {
        takenBack(now);
      }
    }
    last = history;
    undone = now;
  }

  private Viewport before(Edit step) {
    return before.getOrDefault(last, Map.of()).get(step);
  }

  private void takenBack(Edit step) {
    Viewport was = before(step);
    if (was != null && was.yUp() == canvas.viewport().yUp()) {
      canvas.setViewport(was);
    }
    keepInSight();
  }

  private void doneAgain(Edit step) {
    if (before(step) != null) {
      canvas.showWell();
    }
    keepInSight();
  }

  private void keepInSight() {
    if (!canvas.isAnyInSight()) {
      canvas.showWell();
    }
  }
}
