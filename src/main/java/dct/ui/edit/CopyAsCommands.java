package dct.ui.edit;

import dct.core.Decimals;
import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.io.DataFile;
import dct.io.FileEnding;
import dct.io.format.CannotHold;
import dct.io.format.Drawing;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.CommandRegistry;
import dct.ui.document.BulkEdit;
import dct.ui.document.Document;
import dct.ui.vertices.RowsText;
import dct.ui.workbench.Workbench;
import java.awt.Toolkit;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;

/**
 * The commands that copy vertices as other programs paste them: the selected ones, or all if none
 * is.
 */
public final class CopyAsCommands {
  private final Workbench workbench;
  private final CanvasPanel canvas;

  private CopyAsCommands(Workbench workbench, CanvasPanel canvas) {
    this.workbench = workbench;
    this.canvas = canvas;
  }

  /**
   * Offers the commands for the documents of the workbench.
   *
   * @param canvas says whether y grows upwards
   */
  public static void offer(CommandRegistry commands, Workbench workbench, CanvasPanel canvas) {
    new CopyAsCommands(workbench, canvas).offer(commands);
  }

  private void offer(CommandRegistry commands) {
    commands
        .add(
            "Copy as WKT",
            "",
            "Copies the selected vertices, or all, as POLYGON or MULTIPOINT",
            () -> copy("WKT", drawing -> text(FileEnding.WKT, drawing)))
        .enabledWhen(this::isAny);
    commands
        .add(
            "Copy as GeoJSON",
            "",
            "Copies the selected vertices, or all, as a Polygon or MultiPoint of GeoJSON",
            () -> copy("GeoJSON", drawing -> text(FileEnding.GEOJSON, drawing)))
        .enabledWhen(this::isAny);
    commands
        .add(
            "Copy for Ipe",
            "",
            "Copies the selected vertices, or all, as a path or as marks; as they are seen here",
            () -> copy("a selection of Ipe", this::ipe))
        .enabledWhen(this::isAny);
  }

  private boolean isAny() {
    return workbench.active().filter(editor -> editor.document().size() > 0).isPresent();
  }

  private void copy(String format, Function<Drawing, String> write) {
    Document document = workbench.document();
    Drawing drawing =
        workbench.selection().isEmpty()
            ? document.drawing("", Optional.empty())
            : Drawing.of("", document.domain(), workbench.selection().of(document.points()));
    try {
      drawing.requireRingsAlone();
    } catch (CannotHold e) {
      workbench.say("Nothing was copied: " + e.getMessage());
      return;
    }
    Points points = drawing.points();
    Toolkit.getDefaultToolkit()
        .getSystemClipboard()
        .setContents(new RowsText(() -> write.apply(drawing)), null);
    String words = BulkEdit.words(points.size(), document.domain()).toLowerCase(Locale.ROOT);
    workbench.say("Copied " + words + " as " + format);
  }

  private static String text(FileEnding ending, Drawing drawing) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try {
      DataFile.write(out, ending, drawing, Progress.NONE);
    } catch (IOException e) {
      throw new UncheckedIOException(e); // both formats hold any points
    }
    return out.toString(StandardCharsets.UTF_8);
  }

  /** In Ipe y grows upwards; where it does not here, its sign is changed, which rounds nothing. */
  private String ipe(Drawing drawing) {
    StringBuilder text = new StringBuilder("<ipeselection pos=\"0 0\">\n");
    Points points = drawing.points();
    if (drawing.outline().isPresent()) {
      path(text, drawing.outline().get());
    } else {
      for (int v = 0; v < points.size(); v++) {
        place(text.append("<use name=\"mark/disk(sx)\" pos=\""), points, v);
        text.append("\" size=\"normal\" stroke=\"black\"/>\n");
      }
    }
    return text.append("</ipeselection>\n").toString();
  }

  /** All rings as one path, so that what is filled has the holes. */
  private void path(StringBuilder text, Rings rings) {
    text.append("<path stroke=\"black\">\n");
    for (int r = 0; r < rings.count(); r++) {
      for (int k = 0; k < rings.size(r); k++) {
        place(text, rings.points(), rings.vertex(r, k));
        text.append(k == 0 ? " m\n" : " l\n");
      }
      text.append("h\n");
    }
    text.append("</path>\n");
  }

  private void place(StringBuilder text, Points points, int v) {
    double sign = canvas.viewport().yUp() ? 1 : -1;
    Decimals.append(text, points.x(v));
    text.append(' ');
    Decimals.append(text, sign * points.y(v));
  }
}
