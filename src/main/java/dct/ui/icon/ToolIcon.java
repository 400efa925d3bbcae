package dct.ui.icon;

import dct.render.Ink;
import dct.render.Theme;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.function.Consumer;
import javax.swing.Icon;

/**
 * The icons of the tool bar: lines on a square of 20 units, sharp at any scale, in the colours of
 * the look; grey where their button is disabled.
 */
public enum ToolIcon implements Icon {
  NEW(b -> b.outline(5, 2.5, 11.5, 2.5, 15, 6, 15, 17.5, 5, 17.5).line(11.5, 2.5, 11.5, 6, 15, 6)),
  OPEN(
      b ->
          b.line(4, 16, 2.5, 16, 2.5, 4.5, 7.5, 4.5, 9.5, 6.5, 16, 6.5, 16, 9)
              .outline(5.5, 9, 18, 9, 15.5, 16, 3, 16)),
  SAVE(
      b ->
          b.outline(3, 3, 14, 3, 17, 6, 17, 17, 3, 17)
              .line(6.5, 3, 6.5, 7, 12.5, 7, 12.5, 3)
              .line(6, 17, 6, 11, 14, 11, 14, 17)),
  UNDO(b -> b.curve(4, 8, 12, 8, 17, 9, 15.5, 16).line(8, 4, 4, 8, 8, 12)),
  REDO(b -> b.curve(16, 8, 8, 8, 3, 9, 4.5, 16).line(12, 4, 16, 8, 12, 12)),
  MOST_EVEN(b -> quadrilateral(b).even(4, 15.5, 2.6).even(16, 15.5, 2.6).even(10, 4, 2.6)),
  MOST_ODD(b -> quadrilateral(b).odd(4, 15.5, 2.6).odd(16, 15.5, 2.6).odd(10, 4, 2.6)),
  FLIP(
      b ->
          b.outline(10, 2.5, 17.5, 10, 10, 17.5, 2.5, 10)
              .ink(Ink.DIAGONAL)
              .line(10, 2.5, 10, 17.5)
              .ink(Ink.FLIPPED)
              .line(2.5, 10, 17.5, 10)),
  WISH(b -> b.ink(Ink.UNMET).ring(10, 10, 7).odd(10, 10, 3.4)),
  ZOOM_IN(b -> lens(b).line(5.5, 8.5, 11.5, 8.5).line(8.5, 5.5, 8.5, 11.5)),
  ZOOM_OUT(b -> lens(b).line(5.5, 8.5, 11.5, 8.5)),
  FIT(
      b ->
          b.line(2.5, 6.5, 2.5, 2.5, 6.5, 2.5)
              .line(13.5, 2.5, 17.5, 2.5, 17.5, 6.5)
              .line(17.5, 13.5, 17.5, 17.5, 13.5, 17.5)
              .line(6.5, 17.5, 2.5, 17.5, 2.5, 13.5)
              .outline(6, 13, 14, 13, 10, 6)),
  NUMBERS(b -> b.line(3, 8, 6, 15, 9, 8).line(12, 6, 14.5, 4, 14.5, 15).line(12, 15, 17, 15)),
  LEGEND(
      b ->
          b.line(9, 5, 17.5, 5)
              .line(9, 10.5, 17.5, 10.5)
              .line(9, 16, 14.5, 16)
              .even(4.5, 5, 2.4)
              .odd(4.5, 10.5, 2.4)
              .ink(Ink.DIAGONAL)
              .line(2, 16, 7, 16));

  private static final int SIZE = 20;
  private static final Color GREY_ON_LIGHT = new Color(0xB4B8C0);
  private static final Color GREY_ON_DARK = new Color(0x5C6068);
  private static final int HALF = 128; // of the brightness of a ground

  @SuppressWarnings("ImmutableEnumChecker") // the drawings hold nothing that could change
  private final transient Consumer<Brush> drawing;

  ToolIcon(Consumer<Brush> drawing) {
    this.drawing = drawing;
  }

  private static Brush quadrilateral(Brush brush) {
    return brush.outline(4, 15.5, 16, 15.5, 10, 4);
  }

  private static Brush lens(Brush brush) {
    return brush.ring(8.5, 8.5, 6).line(13, 13, 17.5, 17.5);
  }

  @Override
  public void paintIcon(Component c, Graphics g, int x, int y) {
    Graphics2D graphics = (Graphics2D) g.create();
    graphics.translate(x, y);
    Color ground = c.getBackground();
    boolean dark = (ground.getRed() + ground.getGreen() + ground.getBlue()) / 3 < HALF;
    Color grey = dark ? GREY_ON_DARK : GREY_ON_LIGHT;
    Theme theme = dark ? Theme.DARK : Theme.LIGHT;
    drawing.accept(new Brush(graphics, theme, c.isEnabled() ? null : grey));
    graphics.dispose();
  }

  @Override
  public int getIconWidth() {
    return SIZE;
  }

  @Override
  public int getIconHeight() {
    return SIZE;
  }
}
