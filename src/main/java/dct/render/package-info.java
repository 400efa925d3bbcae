/**
 * Pictures of triangulations: a {@link dct.render.Scene} says what is drawn, a {@link
 * dct.render.Viewport} where, a {@link dct.render.Pen} with what; one {@link
 * dct.render.ScenePainter} serves the screen and every format of {@link dct.render.PictureFile}.
 */
package dct.render;
