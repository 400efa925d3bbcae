/**
 * Pictures of triangulations: a {@link dct.render.Scene} says what is drawn, a {@link
 * dct.render.Viewport} where, a {@link dct.render.Pen} with what; one {@link
 * dct.render.ScenePainter} serves screen, PNG and SVG.
 */
package dct.render;
