package dct.io;

import dct.core.Progress;
import dct.io.format.Choice;
import dct.io.format.Columns;
import dct.io.format.Format;
import dct.io.format.SeveralShapes;
import dct.io.format.Shapes;
import dct.io.text.BadInputException;
import dct.problem.Solution;
import dct.problem.verify.Claims;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.Optional;

/**
 * What a file claims of a triangulation: a result of the program, or a file of another program with
 * triangles or edges.
 */
public final class ClaimsFile {
  private final String name;
  private final Choice choice;
  private final Progress progress;

  private ClaimsFile(String name, Choice choice, Progress progress) {
    this.name = name;
    this.choice = choice;
    this.progress = progress;
  }

  /**
   * Reads a file.
   *
   * @param choice which of several triangulations is meant
   * @throws dct.io.format.NoTriangulation if its triangles or edges are no triangulation
   * @throws dct.io.format.SeveralShapes if it holds several and none was picked
   * @throws BadInputException if it holds no triangulation, or there is no such file
   */
  public static Claims read(Path file, Choice choice, Progress progress) {
    return PointFile.open(
        file,
        progress,
        (name, in) -> new ClaimsFile(name, choice, progress).read(in, Optional.of(file)));
  }

  /** The same for a stream. */
  public static Claims read(String name, InputStream in, Choice choice) throws IOException {
    return new ClaimsFile(name, choice, Progress.NONE).read(in, Optional.empty());
  }

  private Claims read(InputStream in, Optional<Path> file) throws IOException {
    return PointFile.recognized(
        name, in, file, Columns.TOLD_BY_CONTENT, claims -> claims, this::foreign);
  }

  private Claims foreign(Format format, Shapes shapes) {
    if (shapes.shapes().stream().noneMatch(shape -> shape.faces().isPresent())) {
      throw none(shapes);
    }
    try {
      Solution solution =
          ChosenShape.of(name, shapes, format.yUp(), choice, progress)
              .solution(progress)
              .orElseThrow(() -> none(shapes));
      return ResultJson.claims(solution).withoutLines();
    } catch (SeveralShapes several) {
      throw SeveralShapes.mustChoose(name, several.shapes());
    }
  }

  private BadInputException none(Shapes shapes) {
    return new BadInputException(
        name,
        0,
        "the format is "
            + shapes.format()
            + ", and it holds no triangulation; triangulate it first");
  }
}
