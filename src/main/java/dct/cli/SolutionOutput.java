package dct.cli;

import dct.core.Progress;
import dct.io.DataFile;
import dct.io.FileEnding;
import dct.io.PointFile;
import dct.io.ResultJson;
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

/** Writes a solution in the format that the name of an output asks for. */
final class SolutionOutput {
  private SolutionOutput() {}

  /**
   * Writes one output; {@code -} is the whole result on standard output.
   *
   * @param figure how a picture looks
   * @throws UsageException if the ending of the name is no format
   */
  static void write(
      Solution solution,
      Optional<ResultJson.Millis> millis,
      String output,
      Figure figure,
      Console console)
      throws IOException {
    if (output.equals(Verb.STANDARD_STREAM)) {
      ResultJson.write(console.out(), solution, millis);
      console.out().flush();
      return;
    }
    Path file = Path.of(output);
    Instance instance = solution.instance();
    switch (Verb.ending(output)) {
      case TXT -> PointFile.write(file, instance.domain(), instance.points(), Progress.NONE);
      case JSON -> ResultJson.write(file, solution, millis, Progress.NONE);
      default -> {
        if (!writeData(file, Drawing.of(solution), console)) {
          write(Scene.of(solution), figure, title(instance.name()), file, console);
        }
      }
    }
  }

  /** Writes data in the format of another program, if the file's name asks for one. */
  static boolean writeData(Path file, Drawing drawing, Console console) throws IOException {
    FileEnding ending = Verb.ending(file.toString());
    if (!DataFile.isOf(ending)) {
      return false;
    }
    List<Path> written = DataFile.write(file, ending, drawing, Progress.NONE);
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
  static void write(Scene scene, Figure figure, String title, Path file, Console console)
      throws IOException {
    PictureFile.warning(scene, file)
        .ifPresent(
            warning -> console.err().println(Shown.harmless(file.toString()) + ": " + warning));
    PictureFile.write(scene, figure, title, file, Progress.NONE);
  }
}
