package dct.ui.icon;

import dct.render.Ink;
import dct.render.Theme;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.RenderingHints;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;

/** The program's icon: a small triangulation with even and odd vertices. */
public final class ProgramIcon {
  private static final int[] SIZES = {16, 20, 24, 32, 40, 48, 64, 128, 256};
  private static final double UNITS = 32; // the side of the square that it is drawn on
  private static final double ARC = 7;

  private ProgramIcon() {}

  /** The icon in the sizes that desktops ask for, each drawn for itself. */
  public static List<Image> images() {
    return Arrays.stream(SIZES).mapToObj(size -> (Image) image(size)).toList();
  }

  /** The icon in one size, in pixels, with corners that are clear. */
  public static BufferedImage image(int size) {
    BufferedImage image = new BufferedImage(size, size, BufferedImage.TYPE_INT_ARGB);
    Graphics2D graphics = image.createGraphics();
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.scale(size / UNITS, size / UNITS);
    graphics.setColor(new Color(Ink.BACKGROUND.rgb(Theme.LIGHT)));
    graphics.fill(new RoundRectangle2D.Double(0, 0, UNITS, UNITS, ARC, ARC));
    draw(new Brush(graphics, Theme.LIGHT, null), size < SIZES[2] ? 4.2 : 3.2);
    graphics.dispose();
    return image;
  }

  /** Small icons have larger dots, so that their colours can still be seen. */
  private static void draw(Brush brush, double dot) {
    double[] outline = {16, 5, 27, 13, 23, 27, 9, 27, 5, 13};
    brush.ink(Ink.INSIDE).filled(outline);
    brush.ink(Ink.DIAGONAL).width(1.8).line(16, 5, 9, 27).line(16, 5, 23, 27);
    brush.ink(Ink.BOUNDARY).width(1.8).outline(outline);
    brush.even(16, 5, dot).even(27, 13, dot).even(5, 13, dot);
    brush.odd(23, 27, dot).odd(9, 27, dot);
  }
}
