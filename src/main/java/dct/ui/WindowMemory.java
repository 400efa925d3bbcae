package dct.ui;

import dct.render.Labels;
import dct.ui.canvas.CanvasPanel;
import dct.ui.dialog.Placement;
import dct.ui.result.Arrangement;
import dct.ui.session.Settings;
import dct.ui.solve.ResultFrames;
import dct.ui.workbench.Workbench;
import javax.swing.JFrame;

/** How a window looks, remembered for the next one. */
final class WindowMemory {
  private final JFrame window;
  private final Workbench workbench;
  private final CanvasPanel canvas;
  private final ResultFrames results;
  private final Settings settings;

  /** The memory of a window in these settings. */
  WindowMemory(
      JFrame window,
      Workbench workbench,
      CanvasPanel canvas,
      ResultFrames results,
      Settings settings) {
    this.window = window;
    this.workbench = workbench;
    this.canvas = canvas;
    this.results = results;
    this.settings = settings;
  }

  /** Has the window look as the last one did. */
  void restore() {
    canvas.setLabels(new Labels(settings.isOn("labels.numbers"), settings.isOn("labels.degrees")));
    workbench.setShowsBound(settings.isOn("view.bound"));
    results.arrange(Arrangement.of(settings.get("results.arrangement").orElse("")));
    results.setInWindow(settings.isOn("results.inWindow"));
    if (settings.isOn("view.yUp")) {
      canvas.setViewport(canvas.viewport().flipped(0, 0));
    }
  }

  /** Tells the settings how the window looks. */
  void remember() {
    settings.put("labels.numbers", canvas.labels().numbers());
    settings.put("labels.degrees", canvas.labels().degrees());
    settings.put("view.bound", workbench.showsBound());
    settings.put("results.arrangement", results.arrangement().word());
    settings.put("results.inWindow", results.isInWindow());
    settings.put("view.yUp", canvas.viewport().yUp());
    Placement.remember(window, settings);
  }
}
