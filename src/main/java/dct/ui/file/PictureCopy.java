package dct.ui.file;

import dct.render.PictureFile;
import dct.render.PictureStyle;
import dct.render.Scene;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.CommandRegistry;
import dct.ui.job.Jobs;
import java.awt.Image;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.image.BufferedImage;
import java.util.Locale;
import java.util.function.Consumer;

/** The command that copies what a canvas shows as a picture, which other programs paste. */
public final class PictureCopy {
  private final CanvasPanel canvas;
  private final Jobs jobs;
  private final Consumer<String> said;

  private PictureCopy(CanvasPanel canvas, Jobs jobs, Consumer<String> said) {
    this.canvas = canvas;
    this.jobs = jobs;
    this.said = said;
  }

  /**
   * Offers the command.
   *
   * @param jobs draw the picture in the background
   * @param said is told what was copied
   */
  public static void offer(
      CommandRegistry commands, CanvasPanel canvas, Jobs jobs, Consumer<String> said) {
    commands.add(
        "Copy Picture",
        "",
        "Copies the PNG that Export Picture would write, as it was asked for last",
        () -> new PictureCopy(canvas, jobs, said).copy());
  }

  private void copy() {
    Scene scene = canvas.scene();
    PictureStyle style = FigurePanel.remembered(canvas);
    jobs.update(
        "Copying the picture",
        progress -> PictureFile.image(scene, style, progress),
        this::putOnClipboard);
  }

  private void putOnClipboard(BufferedImage image) {
    Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new Pasted(image), null);
    said.accept(
        String.format(
            Locale.ROOT,
            "Copied a picture of %d × %d pixels",
            image.getWidth(),
            image.getHeight()));
  }

  /** An image on the clipboard. */
  private record Pasted(Image image) implements Transferable {
    @Override
    public DataFlavor[] getTransferDataFlavors() {
      return new DataFlavor[] {DataFlavor.imageFlavor};
    }

    @Override
    public boolean isDataFlavorSupported(DataFlavor flavor) {
      return DataFlavor.imageFlavor.equals(flavor);
    }

    @Override
    public Object getTransferData(DataFlavor flavor) throws UnsupportedFlavorException {
      if (!isDataFlavorSupported(flavor)) {
        throw new UnsupportedFlavorException(flavor);
      }
      return image;
    }
  }
}
