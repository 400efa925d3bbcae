package dct.ui.canvas;

import dct.core.Progress;
import dct.core.geometry.Box;
import dct.render.GraphicsPen;
import dct.render.Scene;
import dct.render.ScenePainter;
import dct.render.SceneRaster;
import dct.render.Theme;
import dct.render.Viewport;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;

/**
 * Everything that the picture on a canvas depends on.
 *
 * @param scene what is shown
 * @param viewport where
 * @param theme in which colours
 * @param size of the canvas
 * @param pixels of the screen per pixel of the canvas
 */
record View(Scene scene, Viewport viewport, Theme theme, Dimension size, double pixels) {

  /** The picture, drawn into an image of {@link #width} by {@link #height}. */
  void draw(BufferedImage image) {
    SceneRaster.draw(scene, viewport, theme, pixels, image, Progress.NONE);
  }

  /**
   * Turns the picture of the other view into that of this one, if they differ only in where one
   * site of the scene is, and by little.
   *
   * @return whether it is the picture of this view now
   */
  boolean redraw(BufferedImage image, View other) {
    return theme == other.theme
        && pixels == other.pixels
        && size.equals(other.size)
        && viewport.equals(other.viewport)
        && SceneRaster.redraw(other.scene, scene, viewport, theme, pixels, image);
  }

  /** Draws what can be seen of the move of a site over an older picture. */
  void paintMoved(Graphics2D graphics) {
    Box screen = new Box(0, 0, size.width, size.height);
    ScenePainter.paintMoved(scene, viewport, screen, new GraphicsPen(graphics, theme));
  }

  /** The width of the picture on the screen. */
  int width() {
    return Math.max(1, (int) Math.ceil(size.width * pixels));
  }

  /** The height of the picture on the screen. */
  int height() {
    return Math.max(1, (int) Math.ceil(size.height * pixels));
  }

  /** Whether the picture of the other view, moved and scaled, tells what this one will show. */
  boolean isLike(View other) {
    return Math.abs(scene.size() - other.scene.size()) <= 1
        && theme == other.theme
        && viewport.yUp() == other.viewport.yUp();
  }

  /** Puts the picture of the other view where this one shows the same. */
  AffineTransform over(View other) {
    double zoom = viewport.scale() / other.viewport.scale();
    AffineTransform place = new AffineTransform();
    place.translate(
        viewport.screenX(other.viewport.modelX(0)), viewport.screenY(other.viewport.modelY(0)));
    place.scale(zoom / other.pixels, zoom / other.pixels);
    return place;
  }
}
