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

  /** The screen that it fills. */
  Box screen() {
    return new Box(0, 0, width, height);
  }
}
