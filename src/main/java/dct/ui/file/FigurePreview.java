package dct.ui.file;

import dct.core.Progress;
import dct.render.PictureFile;
import dct.render.PictureStyle;
import dct.render.Scene;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.JPanel;
import javax.swing.SwingWorker;

/** A small picture of what will be written, drawn in the background once there is a panel. */
final class FigurePreview extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int WIDTH = 300;
  private static final int HEIGHT = 210;

  private final transient Scene scene;
  private final transient AtomicInteger turn = new AtomicInteger();
  private transient Optional<? extends PictureStyle> wished = Optional.empty();
  private transient BufferedImage image;

  /** A preview of pictures of a scene, empty as yet. */
  FigurePreview(Scene scene) {
    this.scene = scene;
    setOpaque(false);
    setPreferredSize(new Dimension(WIDTH, HEIGHT));
    setName("preview");
    getAccessibleContext().setAccessibleName("Preview");
  }

  /** Shows a picture once it is drawn; nothing if there is none. */
  void show(Optional<? extends PictureStyle> style) {
    wished = style;
    image = null;
    repaint();
    if (isDisplayable()) {
      draw();
    }
  }

  private void draw() {
    int mine = turn.incrementAndGet();
    wished.ifPresent(shown -> new Drawing(shown, mine).execute());
  }

  @Override
  public void addNotify() {
    super.addNotify();
    draw();
  }

  /** The drawing of one picture, in the background. */
  private final class Drawing extends SwingWorker<BufferedImage, Void> {
    private final PictureStyle style;
    private final int mine;

    Drawing(PictureStyle style, int mine) {
      this.style = style;
      this.mine = mine;
    }

    @Override
    protected BufferedImage doInBackground() {
      // Twice as fine as the panel, for displays whose pixels are.
      return PictureFile.preview(scene, style, 2 * WIDTH, new UntilAnother(mine));
    }

    @Override
    protected void done() {
      try {
        take(get(), mine);
      } catch (ExecutionException | InterruptedException e) {
        take(null, mine); // another one has been asked for, or there is no memory for it
      }
    }
  }

  /** Stops a drawing as soon as another one is asked for. */
  private final class UntilAnother implements Progress {
    private final int mine;

    UntilAnother(int mine) {
      this.mine = mine;
    }

    @Override
    public void report(double part, String message) {}

    @Override
    public boolean isCancelled() {
      return turn.get() != mine;
    }
  }

  private void take(BufferedImage drawn, int mine) {
    if (turn.get() == mine) {
      image = drawn;
      repaint();
    }
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    if (image != null) {
      double across = (double) getWidth() / image.getWidth();
      double part = Math.min(across, (double) getHeight() / image.getHeight());
      int width = (int) Math.round(part * image.getWidth());
      int height = (int) Math.round(part * image.getHeight());
      Graphics2D graphics = (Graphics2D) g.create();
      graphics.setRenderingHint(
          RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
      graphics.drawImage(image, (getWidth() - width) / 2, 0, width, height, null);
      graphics.dispose();
    }
  }
}
