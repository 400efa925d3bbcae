package dct.ui.menu;

import dct.render.Labels;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.CommandRegistry;

/** The commands that say how a canvas shows what it shows. */
public final class ViewCommands {
  private static final double ZOOM_STEP = 1.5;

  private final CanvasPanel canvas;

  private ViewCommands(CanvasPanel canvas) {
    this.canvas = canvas;
  }

  /** Offers the commands of a canvas. */
  public static void offer(CommandRegistry commands, CanvasPanel canvas) {
    new ViewCommands(canvas).offer(commands);
  }

  private void offer(CommandRegistry commands) {
    commands
        .add("Zoom In", "ctrl PLUS", "Shows less, larger; so does the wheel", () -> zoom(ZOOM_STEP))
        .alsoOn("ctrl EQUALS", "ctrl shift EQUALS", "ctrl ADD");
    commands
        .add(
            "Zoom Out",
            "ctrl MINUS",
            "Shows more, smaller; so does the wheel",
            () -> zoom(1 / ZOOM_STEP))
        .alsoOn("ctrl SUBTRACT");
    commands.add("Fit", "F", "Shows everything as large as it fits", canvas::fit);
    commands
        .add(
            "Actual Size",
            "ctrl 0",
            "Shows one unit as one pixel, the origin in the corner",
            canvas::showActualSize)
        .alsoOn("ctrl NUMPAD0");
    commands
        .add("Vertex Numbers", "N", "Writes the number of each vertex", this::numbers)
        .selectedWhen(() -> canvas.labels().numbers());
    commands
        .add("Vertex Degrees", "G", "Writes the degree of each vertex", this::degrees)
        .selectedWhen(() -> canvas.labels().degrees());
    commands
        .add(
            "Legend",
            "K",
            "Says what the colours and shapes stand for",
            () -> canvas.setLegend(!canvas.hasLegend()))
        .selectedWhen(canvas::hasLegend);
    commands
        .add("Y Axis Up", "U", "Lets y run up instead of down", this::turnAxis)
        .selectedWhen(() -> canvas.viewport().yUp());
    commands
        .add("Dark Look", "ctrl D", "Light ink on a dark ground", Look::toggleDark)
        .selectedWhen(Look::isDark);
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
