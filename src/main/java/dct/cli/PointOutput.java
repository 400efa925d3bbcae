package dct.cli;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.io.FileEnding;
import dct.io.PointDocument;
import dct.io.PointFile;
import dct.io.ResultJson;
import dct.io.format.Drawing;
import dct.render.Figure;
import dct.render.Scene;
import java.io.IOException;
import java.util.List;

/** Writes points in the format of an output. */
final class PointOutput {
  private PointOutput() {}

  /**
   * Writes one output; on standard output it is text, unless another format is asked for.
   *
   * @param figure how a picture looks
   */
  static void write(PointDocument document, Output output, Figure figure, Console console)
      throws IOException {
    FileEnding ending = output.format().orElse(FileEnding.TXT);
    switch (ending) {
      case TXT -> writeText(document, output, console);
      case JSON -> output.write(console, out -> ResultJson.write(out, document));
      default -> {
        Drawing drawing =
            document
                .rings()
                .map(rings -> Drawing.of(name(document), rings))
                .orElseGet(() -> Drawing.of(name(document), document.domain(), document.points()));
        if (!SolutionOutput.writeData(output, ending, drawing, console)) {
          SolutionOutput.write(scene(document), figure, name(document), output, ending, console);
        }
      }
    }
  }

  private static void writeText(PointDocument document, Output output, Console console)
      throws IOException {
    if (output.isStandard()) {
      output.write(console, out -> PointFile.write(out, document));
    } else {
      PointFile.write(output.file(), document, Progress.NONE);
    }
  }

  /** The name of the document's file, without folder and ending. */
  private static String name(PointDocument document) {
    return SolutionOutput.title(document.source());
  }

  private static Scene scene(PointDocument document) {
    boolean sites = document.domain() == Domain.SITES;
    return sites
        ? Scene.sites(document.points())
        : Scene.outline(document.outline(), false, List.of());
  }
}
