package dct.ui.file;

import dct.core.Progress;
import dct.io.CannotWriteException;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.render.PictureFile;
import dct.render.PictureView;
import dct.render.Scene;
import dct.ui.canvas.CanvasPanel;
import dct.ui.dialog.Chooser;
import dct.ui.job.Jobs;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GridLayout;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** Writes what a canvas shows to a picture file that the user names. */
public final class PictureExport {
  private static final String TITLE = "Export Picture";
  private static final int[] SCALES = {1, 2, 4};

  private final Component parent;
  private final CanvasPanel canvas;
  private final JComboBox<String> scales = new JComboBox<>();

  private PictureExport(Component parent, CanvasPanel canvas) {
    this.parent = parent;
    this.canvas = canvas;
    Dimension size = canvas.getSize();
    for (int scale : SCALES) {
      scales.addItem(
          String.format(
              Locale.ROOT, "%d× (%d × %d)", scale, scale * size.width, scale * size.height));
    }
    scales.setName("scale");
    scales.setToolTipText("Pixels of a PNG; other pictures have none and are sharp at any size");
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
        Chooser.PICTURES.ask(
            parent, suggested, TITLE, chooser -> chooser.setAccessory(accessory()));
    if (typed.isPresent()) {
      Path file = FileEnding.PNG.orElseOn(typed.get(), Content.PICTURE);
      if (!Files.exists(file) || Chooser.confirmReplacing(parent, file)) {
        export(file, jobs, done);
      }
    }
  }

  /** A file's name without its ending, or words joined to one. */
  public static String fileName(String name) {
    return name.replaceFirst("\\.[A-Za-z]{1,5}$", "").replaceAll("[^\\p{L}\\p{N}.+-]+", "_");
  }

  private JPanel accessory() {
    JLabel label = new JLabel("Size of a PNG:");
    label.setDisplayedMnemonic('z');
    label.setLabelFor(scales);
    JPanel lines = new JPanel(new GridLayout(0, 1, 0, 4));
    lines.setBorder(BorderFactory.createEmptyBorder(0, 12, 0, 0));
    lines.add(label);
    lines.add(scales);
    JPanel accessory = new JPanel(new BorderLayout());
    accessory.add(lines, BorderLayout.NORTH);
    return accessory;
  }

  private void export(Path file, Jobs jobs, Consumer<String> done) {
    Scene scene = canvas.scene();
    PictureView view =
        new PictureView(canvas.viewport(), canvas.getWidth(), canvas.getHeight(), canvas.notes());
    int scale = SCALES[scales.getSelectedIndex()];
    jobs.write(
        "Exporting " + file.getFileName(),
        progress -> write(scene, view, scale, file, progress),
        written -> done.accept("Exported " + written));
  }

  private static Path write(
      Scene scene, PictureView view, int scale, Path file, Progress progress) {
    try {
      PictureFile.write(scene, view, scale, file, progress);
      return file;
    } catch (CannotWriteException e) {
      throw new UncheckedIOException(e);
    }
  }
}
