package dct.cli;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.io.PointDocument;
import dct.io.PointFile;
import dct.io.ResultJson;
import dct.io.format.Drawing;
import dct.render.Figure;
import dct.render.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** Writes points in the format that the name of an output asks for. */
final class PointOutput {
  private PointOutput() {}

  /**
   * Writes one output; {@code -} is text on standard output.
   *
   * @param figure how a picture looks
   * @throws UsageException if the ending of the name is no format
   */
  static void write(PointDocument document, String output, Figure figure, Console console)
      throws IOException {
    if (output.equals("-")) {
      PointFile.write(console.out(), document);
      console.out().flush();
      return;
    }
    Path file = Path.of(output);
    switch (Verb.ending(output)) {
      case TXT -> PointFile.write(file, document, Progress.NONE);
      case JSON -> ResultJson.write(file, document, Progress.NONE);
      default -> {
        Drawing drawing = Drawing.of(name(document), document.domain(), document.points());
        if (!SolutionOutput.writeData(file, drawing, console)) {
          SolutionOutput.write(scene(document), figure, name(document), file, console);
        }
      }
    }
  }

  /** The name of the document's file, without folder and ending. */
  private static String name(PointDocument document) {
    return SolutionOutput.title(document.source());
  }

  private static Scene scene(PointDocument document) {
    return document.domain() == Domain.SITES
        ? Scene.sites(document.points())
        : Scene.polygon(document.points(), false, List.of());
  }
}
