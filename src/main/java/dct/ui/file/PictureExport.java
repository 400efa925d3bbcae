package dct.ui.file;

import dct.io.CannotWriteException;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.render.Figure;
import dct.render.PictureFile;
import dct.render.PictureView;
import dct.render.Scene;
import dct.ui.canvas.CanvasPanel;
import dct.ui.dialog.Ask;
import dct.ui.dialog.Chooser;
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

  private final Component parent;
  private final CanvasPanel canvas;
  private final FigurePanel options;

  private PictureExport(Component parent, CanvasPanel canvas) {
    this.parent = parent;
    this.canvas = canvas;
    this.options = new FigurePanel(canvas.scene(), canvas.viewport().yUp());
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
    Path suggested = Path.of(fileName(name) + ".png");
    Optional<Path> typed =
        Chooser.PICTURES.ask(parent, suggested, TITLE, chooser -> chooser.setAccessory(options));
    if (typed.isPresent()) {
      Path file = FileEnding.PNG.orElseOn(typed.get(), Content.PICTURE);
      options.remember();
      boolean isFree = !Files.exists(file) || Chooser.confirmReplacing(parent, file);
      if (isFree && isMeant(file)) {
        export(name, file, jobs, done);
      }
    }
  }

  /** A file's name without its ending, or words joined to one. */
  public static String fileName(String name) {
    return FileEnding.without(name).replaceAll("[^\\p{L}\\p{N}.+-]+", "_");
  }

  /** Says what should be said before; whether to go on. */
  private boolean isMeant(Path file) {
    return PictureFile.warning(canvas.scene(), file)
        .map(warning -> Ask.confirm(parent, TITLE, warning + ".", "Export"))
        .orElse(true);
  }

  private void export(String name, Path file, Jobs jobs, Consumer<String> done) {
    Scene scene = canvas.scene();
    PictureView view =
        new PictureView(canvas.viewport(), canvas.getWidth(), canvas.getHeight(), canvas.notes());
    Optional<Figure> figure = options.figure();
    int scale = options.scale();
    jobs.write(
        "Exporting " + file.getFileName(),
        progress ->
            write(
                () -> {
                  if (figure.isPresent()) {
                    PictureFile.write(scene, figure.get(), name, file, progress);
                  } else {
                    PictureFile.write(scene, view, scale, file, progress);
                  }
                },
                file),
        written -> done.accept("Exported " + written));
  }

  /** Writes a file. */
  @FunctionalInterface
  private interface Writing {
    void write() throws CannotWriteException;
  }

  private static Path write(Writing writing, Path file) {
    try {
      writing.write();
      return file;
    } catch (CannotWriteException e) {
      throw new UncheckedIOException(e);
    }
  }
}
