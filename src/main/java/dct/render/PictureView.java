package dct.render;

import dct.core.geometry.Box;

/**
 * What a window shows of a scene, light on white; immutable.
 *
 * @param viewport which part of it
 * @param width of the picture, as {@code height} in pixels of a screen
 * @param notes what is written in its corners
 * @param scale pixels of a PNG for each pixel of the screen; other pictures have no pixels
 */
public record PictureView(Viewport viewport, int width, int height, Notes notes, int scale)
    implements PictureStyle {

  /** The screen that it fills. */
  Box screen() {
    return new Box(0, 0, width, height);
  }
}
