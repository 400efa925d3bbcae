package dct.ui.canvas;

import dct.render.Box;
import dct.render.GraphicsPen;
import dct.render.Scene;
import dct.render.ScenePainter;
import dct.render.Theme;
import dct.render.Viewport;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;

/** A scene drawn once and kept until something about it changes, so that overlays cost nothing. */
final class SceneImage {
  /** Scenes of more edges are drawn without smoothing: several times faster, and as legible. */
  private static final int SMOOTH_EDGES = 20_000;

  /** Everything that the image depends on. */
  private record Key(Scene scene, Viewport view, Theme theme, Dimension size, double pixels) {}

  private Key drawn;
  private BufferedImage image;

  /** Draws the scene over these graphics, in the resolution of their screen. */
  void paint(Graphics2D graphics, Scene scene, Viewport view, Theme theme, Dimension size) {
    Key key = new Key(scene, view, theme, size, graphics.getTransform().getScaleX());
    if (!key.equals(drawn)) {
      image = draw(key);
      drawn = key;
    }
    drawImage(graphics, image, key);
  }

  private static BufferedImage draw(Key key) {
    int width = (int) Math.ceil(key.size.width * key.pixels);
    int height = (int) Math.ceil(key.size.height * key.pixels);
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    graphics.scale(key.pixels, key.pixels);
    boolean smooth = key.scene.edgeCount() <= SMOOTH_EDGES;
    GraphicsPen pen = new GraphicsPen(graphics, key.theme, smooth);
    pen.ground(key.size.width, key.size.height);
    Box screen = new Box(0, 0, key.size.width, key.size.height);
    ScenePainter.paint(key.scene, key.view, screen, pen);
    graphics.dispose();
    return image;
  }

  private static void drawImage(Graphics2D graphics, Image image, Key key) {
    AffineTransform back = AffineTransform.getScaleInstance(1 / key.pixels, 1 / key.pixels);
    graphics.drawImage(image, back, null);
  }
}
