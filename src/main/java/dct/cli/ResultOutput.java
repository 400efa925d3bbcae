package dct.cli;

import dct.core.degree.FlipResult;
import dct.io.OffFile;
import dct.io.PointFile;
import dct.io.Result;
import dct.io.ResultJson;
import dct.render.PictureFile;
import dct.render.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Writes a result in the format that the name of an output asks for.
 *
 * @param result the result
 * @param flipped the triangulations before and after flips, if there were any asked for
 */
record ResultOutput(Result result, Optional<FlipResult> flipped) {

  /**
   * Writes one output; {@code -} is the whole result on standard output.
   *
   * @throws UsageException if the ending of the name is no format
   */
  void write(String output, Console console) throws IOException {
    if (output.equals("-")) {
      ResultJson.write(console.out(), result);
      console.out().flush();
      return;
    }
    Path file = Path.of(output);
    switch (Verb.ending(output)) {
      case TXT ->
          PointFile.write(file, result.triangulation().domain(), result.triangulation().points());
      case JSON -> ResultJson.write(file, result);
      case OFF -> OffFile.write(file, result.triangulation());
      default -> PictureFile.write(scene(), file);
    }
  }

  private Scene scene() {
    return flipped
        .map(Scene::of)
        .or(() -> result.optimum().map(Scene::of))
        .orElseGet(() -> Scene.of(result.triangulation()));
  }
}
