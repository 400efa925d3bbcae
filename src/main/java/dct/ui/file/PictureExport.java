package dct.ui.file;

import dct.io.CannotWriteException;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.render.PictureFile;
import dct.render.PictureStyle;
import dct.render.Scene;
import dct.ui.canvas.CanvasPanel;
import dct.ui.dialog.Ask;
import dct.ui.dialog.Chooser;
import dct.ui.dialog.Memory;
import dct.ui.job.Jobs;
import java.awt.Component;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;

/** Writes what a canvas shows to a picture file that the user names. */
public final class PictureExport {
  private static final String TITLE = "Export Picture";
  private static final String ENDING = "figure.ending";

  private final Component parent;
  private final CanvasPanel canvas;
  private final FigurePanel options;

  private PictureExport(Component parent, CanvasPanel canvas) {
    this.parent = parent;
    this.canvas = canvas;
    this.options = new FigurePanel(canvas);
  }

  /**
   * Asks for the file and writes it in the background.
   *
   * @param name what the picture shows
   * @param done is told of the picture once it is written
   */
  public static void ask(
      Component parent, CanvasPanel canvas, String name, Jobs jobs, Consumer<String> done) {
    new PictureExport(parent, canvas).ask(name, jobs, done);
  }

  private void ask(String name, Jobs jobs, Consumer<String> done) {
    Path suggested = Path.of(fileName(name) + Memory.get(ENDING).orElse(".png"));
    Optional<Path> file = askUntilUsable(suggested);
    if (file.isPresent()) {
      options.remember();
      Memory.put(ENDING, FileEnding.require(file.get(), Content.PICTURE).dotted());
      boolean isFree = !Files.exists(file.get()) || Chooser.confirmReplacing(parent, file.get());
      if (isFree && isMeant(file.get())) {
        export(name, file.get(), jobs, done);
      }
    }
  }

  private Optional<Path> askUntilUsable(Path suggested) {
    Optional<Path> file =
        Chooser.PICTURES
            .ask(parent, suggested, TITLE, chooser -> chooser.setAccessory(options))
            .map(typed -> FileEnding.PNG.orElseOn(typed, Content.PICTURE));
    try {
      options.style();
      return file;
    } catch (IllegalArgumentException e) {
      file.ifPresent(typed -> Ask.sorry(parent, TITLE, e.getMessage() + "."));
      return file.flatMap(this::askUntilUsable);
    }
  }

  /** A file's name without its ending, or words joined to one. */
  public static String fileName(String name) {
    return FileEnding.without(name).replaceAll("[^\\p{L}\\p{N}.+-]+", "_");
  }

  /** Says what should be said before; whether to go on. */
  private boolean isMeant(Path file) {
    return PictureFile.warning(canvas.scene(), FileEnding.require(file, Content.PICTURE))
        .map(warning -> Ask.confirm(parent, TITLE, warning + ".", "Export"))
        .orElse(true);
  }

  private void export(String name, Path file, Jobs jobs, Consumer<String> done) {
    Scene scene = canvas.scene();
    PictureStyle style = options.style();
    jobs.write(
        "Exporting " + file.getFileName(),
        progress -> {
          try {
            PictureFile.write(scene, style, name, file, progress);
            return file;
          } catch (CannotWriteException e) {
            throw new UncheckedIOException(e);
          }
        },
        written -> done.accept("Exported " + written));
  }
}
