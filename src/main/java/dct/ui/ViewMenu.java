package dct.ui;

import dct.render.Labels;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.Command;
import dct.ui.command.CommandMenu;

/** View: how a canvas shows what it shows. */
final class ViewMenu {
  private static final double ZOOM_STEP = 1.5;

  private final CanvasPanel canvas;

  private ViewMenu(CanvasPanel canvas) {
    this.canvas = canvas;
  }

  /** The menu of a canvas. */
  static CommandMenu of(CanvasPanel canvas) {
    return new ViewMenu(canvas).menu();
  }

  private CommandMenu menu() {
    return new CommandMenu("View")
        .with(
            new Command(
                "Zoom In",
                "ctrl PLUS",
                "Shows less, larger; so does the wheel",
                () -> zoom(ZOOM_STEP)))
        .with(
            new Command(
                "Zoom Out",
                "ctrl MINUS",
                "Shows more, smaller; so does the wheel",
                () -> zoom(1 / ZOOM_STEP)))
        .with(new Command("Fit", "F", "Shows everything as large as it fits", canvas::fit))
        .with(
            new Command(
                "Actual Size",
                "ctrl 0",
                "Shows one unit as one pixel, the origin in the corner",
                canvas::showActualSize))
        .line()
        .withSwitch(
            new Command("Vertex Numbers", "N", "Writes the number of each vertex", this::numbers),
            canvas.labels().numbers())
        .withSwitch(
            new Command("Vertex Degrees", "G", "Writes the degree of each vertex", this::degrees),
            canvas.labels().degrees())
        .withSwitch(
            new Command("Y Axis Up", "U", "Lets y run up instead of down", this::turnAxis),
            canvas.viewport().yUp())
        .line()
        .withSwitch(
            new Command("Dark Look", "ctrl D", "Light ink on a dark ground", Look::toggleDark),
            Look.isDark());
  }

  private void zoom(double factor) {
    canvas.zoom(factor, canvas.getWidth() / 2.0, canvas.getHeight() / 2.0);
  }

  private void numbers() {
    Labels labels = canvas.labels();
    canvas.setLabels(new Labels(!labels.numbers(), labels.degrees()));
  }

  private void degrees() {
    Labels labels = canvas.labels();
    canvas.setLabels(new Labels(labels.numbers(), !labels.degrees()));
  }

  private void turnAxis() {
    canvas.setViewport(
        canvas.viewport().flipped(canvas.getWidth() / 2.0, canvas.getHeight() / 2.0));
  }
}
