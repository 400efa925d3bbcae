package dct.render;

import dct.core.geometry.Box;

/**
 * What a picture shows of a scene; immutable.
 *
 * @param viewport which part of it
 * @param width of the picture, as {@code height} in pixels of a screen
 * @param notes what is written in its corners
 */
public record PictureView(Viewport viewport, int width, int height, Notes notes) {

  /** The width of a picture unless asked otherwise: that of the thesis's canvas. */
  public static final int WIDTH = 1000;

  /** The height of a picture unless asked otherwise. */
  public static final int HEIGHT = 700;

  /**
   * The whole scene, y downwards.
   *
   * @param legend whether the picture has one
   */
  public static PictureView whole(Scene scene, boolean legend) {
    Notes notes = Notes.at(legend);
    Viewport fitted = notes.fitted(scene, WIDTH, HEIGHT, false);
    Box screen = new Box(0, 0, WIDTH, HEIGHT);
    return new PictureView(fitted, WIDTH, HEIGHT, notes.placed(scene, fitted, screen));
  }

  /** The screen that it fills. */
  Box screen() {
    return new Box(0, 0, width, height);
  }
}
