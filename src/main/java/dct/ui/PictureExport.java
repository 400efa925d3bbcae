package dct.ui;

import dct.io.CannotWriteException;
import dct.render.PictureFile;
import dct.render.PictureFile.Format;
import dct.ui.canvas.CanvasPanel;
import java.awt.Component;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Writes what a canvas shows to a picture file that the user names. */
final class PictureExport {

  private PictureExport() {}

  /** Asks for the file and writes it. */
  static void ask(Component parent, CanvasPanel canvas, String name) {
    Path suggested = Path.of(name.replaceFirst("\\.[A-Za-z]{1,5}$", "") + ".png");
    Optional<Path> typed = Chooser.PICTURES.save(parent, suggested);
    if (typed.isPresent()) {
      Path file = withEnding(typed.get());
      if (!Files.exists(file) || Chooser.confirmReplacing(parent, file)) {
        write(parent, canvas, file);
      }
    }
  }

  private static Path withEnding(Path typed) {
    boolean said = Format.of(typed).isPresent();
    return said ? typed : typed.resolveSibling(typed.getFileName() + ".png");
  }

  private static void write(Component parent, CanvasPanel canvas, Path file) {
    try {
      PictureFile.write(
          canvas.scene(), canvas.viewport(), canvas.getWidth(), canvas.getHeight(), file);
    } catch (CannotWriteException e) {
      Ask.sorry(parent, "Export Picture", e.getMessage());
    }
  }
}
