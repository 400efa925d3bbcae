package dct.ui.canvas;

import dct.render.Ink;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import javax.swing.SwingUtilities;

/**
 * The picture of a scene, drawn once and kept until something about it changes, so that overlays
 * cost nothing. Where one site has moved, it is drawn anew only where that shows. Large scenes are
 * drawn in the background: until the picture is there, that of the view before stands in for it,
 * moved and scaled. Lives on the event thread.
 */
final class SceneImage {
  /** Scenes of so many vertices are drawn within a frame of the screen, and so at once. */
  static final int AT_ONCE = 3_000;

  private static final int IDLE_SECONDS = 5;

  private final Runnable whenDrawn;
  private final Executor background;
  private View drawn; // what the image shows; null before the first
  private BufferedImage image;
  private BufferedImage spare; // what was shown before, to be drawn over
  private boolean drawing; // in the background; the image of the newest view comes after

  /**
   * A picture of nothing.
   *
   * @param whenDrawn is run when a picture was drawn in the background
   */
  SceneImage(Runnable whenDrawn) {
    this(
        whenDrawn,
        new ThreadPoolExecutor(
            0, 1, IDLE_SECONDS, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), SceneImage::thread));
  }

  private static Thread thread(Runnable work) {
    Thread thread = new Thread(work, "canvas");
    thread.setDaemon(true);
    return thread;
  }

  SceneImage(Runnable whenDrawn, Executor background) {
    this.whenDrawn = whenDrawn;
    this.background = background;
  }

  /** Draws the view over these graphics, in the resolution of their screen. */
  void paint(Graphics2D graphics, View view) {
    if (drawn != null && !view.equals(drawn) && view.redraw(image, drawn)) {
      drawn = view;
    }
    if (!view.equals(drawn) && !drawing) {
      draw(view);
    }
    if (view.equals(drawn)) {
      graphics.drawImage(
          image, AffineTransform.getScaleInstance(1 / view.pixels(), 1 / view.pixels()), null);
    } else {
      graphics.setColor(new Color(Ink.BACKGROUND.rgb(view.theme())));
      graphics.fillRect(0, 0, view.size().width, view.size().height);
      if (drawn != null && view.isLike(drawn)) {
        graphics.drawImage(image, view.over(drawn), null);
        view.paintMoved(graphics);
      }
    }
  }

  private void draw(View view) {
    BufferedImage target = target(view);
    if (view.scene().size() <= AT_ONCE) {
      view.draw(target);
      show(view, target);
    } else {
      drawing = true;
      background.execute(() -> drawInBackground(view, target));
    }
  }

  private void drawInBackground(View view, BufferedImage target) {
    boolean[] whole = {false};
    try {
      view.draw(target);
      whole[0] = true;
    } finally {
      SwingUtilities.invokeLater(() -> end(view, target, whole[0]));
    }
  }

  private void end(View view, BufferedImage target, boolean whole) {
    drawing = false;
    if (whole) {
      show(view, target);
      whenDrawn.run();
    }
  }

  private void show(View view, BufferedImage target) {
    spare = image;
    image = target;
    drawn = view;
  }

  private BufferedImage target(View view) {
    boolean fits =
        spare != null && spare.getWidth() == view.width() && spare.getHeight() == view.height();
    return fits
        ? spare
        : new BufferedImage(view.width(), view.height(), BufferedImage.TYPE_INT_RGB);
  }
}
