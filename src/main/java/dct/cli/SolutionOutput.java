package dct.cli;

import dct.core.Progress;
import dct.io.CannotWriteException;
import dct.io.DataFile;
import dct.io.FileEnding;
import dct.io.PointFile;
import dct.io.ResultJson;
import dct.io.format.CannotHold;
import dct.io.format.Drawing;
import dct.io.text.Shown;
import dct.problem.Instance;
import dct.problem.Solution;
import dct.render.Figure;
import dct.render.PictureFile;
import dct.render.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Writes a solution in the format of an output. */
final class SolutionOutput {
  private SolutionOutput() {}

  /**
   * Writes one output; on standard output it is the whole result, unless another format is asked
   * for.
   *
   * @param figure how a picture looks
   */
  static void write(
      Solution solution,
      Optional<ResultJson.Millis> millis,
      Output output,
      Figure figure,
      Console console)
      throws IOException {
    Instance instance = solution.instance();
    FileEnding ending = output.format().orElse(FileEnding.JSON);
    switch (ending) {
      case TXT -> writeText(instance, output);
      case JSON -> output.write(console, out -> ResultJson.write(out, solution, millis));
      default -> {
        if (!writeData(output, ending, Drawing.of(solution), console)) {
          write(Scene.of(solution), figure, title(instance.name()), output, ending, console);
        }
      }
    }
  }

  private static void writeText(Instance instance, Output output) throws IOException {
    if (instance instanceof Instance.OfRegion of) {
      PointFile.write(output.file(), of.region().rings(), Progress.NONE);
    } else {
      PointFile.write(output.file(), instance.domain(), instance.points(), Progress.NONE);
    }
  }

  /** Writes data in the format of another program, if it is one. */
  static boolean writeData(Output output, FileEnding ending, Drawing drawing, Console console)
      throws IOException {
    if (!DataFile.isOf(ending)) {
      return false;
    }
    if (output.isStandard()) {
      try {
        output.write(console, out -> DataFile.write(out, ending, drawing, Progress.NONE));
      } catch (CannotHold e) {
        throw new CannotWriteException(output.name(), e);
      }
      if (DataFile.needsVertices(ending)) {
        console.err().println("-: the vertices are left out; they belong beside it, use --to node");
      }
      return true;
    }
    List<Path> written = DataFile.write(output.file(), ending, drawing, Progress.NONE);
    for (Path beside : written.subList(1, written.size())) {
      console.err().println(Shown.harmless(beside + ": written, too; it holds the vertices"));
    }
    return true;
  }

  /** The name of an input, without folder and ending; empty for standard input. */
  static String title(String source) {
    Path file = source.equals(Verb.STANDARD_STREAM) ? null : Path.of(source).getFileName();
    return file == null ? "" : FileEnding.without(file.toString());
  }

  /** Writes a picture of the whole scene, with a warning if its reader will have trouble. */
  static void write(
      Scene scene, Figure figure, String title, Output output, FileEnding ending, Console console)
      throws IOException {
    PictureFile.warning(scene, ending)
        .ifPresent(
            warning -> console.err().println(Shown.harmless(output.name()) + ": " + warning));
    output.write(
        console, out -> PictureFile.write(scene, figure, title, ending, out, Progress.NONE));
  }
}
