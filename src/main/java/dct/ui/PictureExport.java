package dct.ui;

import dct.core.Progress;
import dct.io.CannotWriteException;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.render.PictureFile;
import dct.render.Scene;
import dct.render.Viewport;
import dct.ui.canvas.CanvasPanel;
import dct.ui.job.Jobs;
import java.awt.Component;
import java.awt.Dimension;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Writes what a canvas shows to a picture file that the user names. */
final class PictureExport {

  private PictureExport() {}

  /** Asks for the file and writes it in the background. */
  static void ask(Component parent, CanvasPanel canvas, String name, Jobs jobs) {
    Path suggested = Path.of(name.replaceFirst("\\.[A-Za-z]{1,5}$", "") + ".png");
    Optional<Path> typed = Chooser.PICTURES.save(parent, suggested);
    if (typed.isPresent()) {
      Path file = withEnding(typed.get());
      if (!Files.exists(file) || Chooser.confirmReplacing(parent, file)) {
        Scene scene = canvas.scene();
        Viewport view = canvas.viewport();
        Dimension size = canvas.getSize();
        jobs.write(
            "Exporting " + file.getFileName(),
            progress -> write(scene, view, size, file, progress),
            written -> {});
      }
    }
  }

  private static Path withEnding(Path typed) {
    return FileEnding.PNG.orElseOn(typed, Content.PICTURE);
  }

  private static Path write(
      Scene scene, Viewport view, Dimension size, Path file, Progress progress) {
    try {
      PictureFile.write(scene, view, size.width, size.height, file, progress);
      return file;
    } catch (CannotWriteException e) {
      throw new UncheckedIOException(e);
    }
  }
}
