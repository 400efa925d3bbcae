package dct.render;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;

/**
 * Draws smoothed shapes straight into the pixels of an image: what {@link GraphicsPen} draws, at
 * many times its speed, so that large scenes follow the mouse.
 *
 * <p>A pixel gets the part of the colour by which the shape covers it, taken from the distance of
 * its centre to the shape's edge.
 */
final class RasterPen implements Pen {
  private static final double TINY = 1; // discs of a smaller radius look like squares
  private static final double SQUARED = Math.sqrt(Math.PI) / 2; // half the side of an equal square
  private static final double DASH = 5;
  private static final double BEYOND = 8; // pixels that a line is followed outside the rows

  private final int[] pixels;
  private final int width;
  private final int left; // the first column that is drawn on
  private final int right; // the column behind the last one
  private final int top; // the first row that is drawn on
  private final int bottom; // the row behind the last one
  private final double scale;
  private final Theme theme;
  private int rgb;
  private double lineWidth;
  private boolean dashed;

  /**
   * A pen for some rows of an image; pens for different rows can be used at the same time.
   *
   * @param image of type {@link BufferedImage#TYPE_INT_RGB}
   * @param scale pixels of the image per pixel of the coordinates
   */
  RasterPen(BufferedImage image, int top, int bottom, double scale, Theme theme) {
    this(image, new Rectangle(0, top, image.getWidth(), bottom - top), scale, theme);
  }

  /** A pen for a part of an image. */
  RasterPen(BufferedImage image, Rectangle part, double scale, Theme theme) {
    this.pixels = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
    this.width = image.getWidth();
    this.left = part.x;
    this.right = part.x + part.width;
    this.top = part.y;
    this.bottom = part.y + part.height;
    this.scale = scale;
    this.theme = theme;
  }

  /** Fills the part with the colour of the ground. */
  void ground() {
    for (int row = top; row < bottom; row++) {
      Arrays.fill(pixels, row * width + left, row * width + right, Ink.BACKGROUND.rgb(theme));
    }
  }

  @Override
  public void style(Stroke stroke) {
    rgb = stroke.ink().rgb(theme);
    lineWidth = stroke.width() * scale;
    dashed = stroke.dashed();
  }

  /** Whole coordinates are the centres of pixels, of the screen's and of the image's. */
  private double device(double coordinate) {
    return (coordinate + 0.5) * scale - 0.5;
  }

  @Override
  public void line(double x1, double y1, double x2, double y2) {
    double ax = device(x1);
    double ay = device(y1);
    double dx = device(x2) - ax;
    double dy = device(y2) - ay;
    double from = Math.max(enter(ax, dx, left, right), enter(ay, dy, top, bottom));
    double to = Math.min(leave(ax, dx, left, right), leave(ay, dy, top, bottom));
    if (from < to) {
      double before = dashed ? from * Math.hypot(dx, dy) : 0;
      if (Math.abs(dy) > Math.abs(dx)) {
        walk(ay + from * dy, ax + from * dx, ay + to * dy, ax + to * dx, true, before);
      } else {
        walk(ax + from * dx, ay + from * dy, ax + to * dx, ay + to * dy, false, before);
      }
    }
  }

  /** The parameter from which on a coordinate that starts at a and grows by d is near the range. */
  private static double enter(double a, double d, int low, int high) {
    double first = low - BEYOND;
    double last = high + BEYOND;
    if (a >= first && a <= last) {
      return 0;
    }
    return d == 0 ? 1 : Math.max(0, ((d > 0 ? first : last) - a) / d);
  }

  private static double leave(double a, double d, int low, int high) {
    double first = low - BEYOND;
    double last = high + BEYOND;
    double end = a + d;
    if (end >= first && end <= last) {
      return 1;
    }
    return d == 0 ? 1 : Math.min(1, ((d > 0 ? last : first) - a) / d);
  }

  /**
   * Draws a line by steps along u, the axis along which it is longer.
   *
   * @param before the length of the line before its first point, for the dashes
   */
  private void walk(double u1, double v1, double u2, double v2, boolean steep, double before) {
    double low = Math.min(u1, u2);
    double high = Math.max(u1, u2);
    double slope = (v2 - v1) / (u2 - u1);
    double cosine = 1 / Math.sqrt(1 + slope * slope);
    double reach = (lineWidth / 2 + 0.5) / cosine;
    int last = Math.min(steep ? bottom : right, (int) Math.ceil(high + 0.5)) - 1;
    for (int i = Math.max(steep ? top : left, (int) Math.ceil(low - 0.5)); i <= last; i++) {
      double part = Math.min(i + 0.5, high) - Math.max(i - 0.5, low);
      if (dashed) {
        double along = before + (i - u1) * Math.signum(u2 - u1) / cosine;
        double step = 0.5 / cosine;
        part *= (inked(along + step) - inked(along - step)) / (2 * step);
      }
      across(i, v1 + slope * (i - u1), reach, cosine, part, steep);
    }
  }

  /** How much of the first so many pixels of a dashed line is not gap. */
  private double inked(double along) {
    double dash = DASH * scale;
    double period = Math.floor(along / (2 * dash));
    return period * dash + Math.min(dash, along - 2 * dash * period);
  }

  /** One step: the pixels with this u that the line covers. */
  private void across(int u, double v, double reach, double cosine, double part, boolean steep) {
    double most = Math.min(1, lineWidth);
    int first = Math.max(steep ? left : top, (int) Math.ceil(v - reach));
    int last = Math.min((steep ? right : bottom) - 1, (int) Math.floor(v + reach));
    for (int w = first; w <= last; w++) {
      double cover = Math.min(most, (reach - Math.abs(w - v)) * cosine) * part;
      mix(steep ? u * width + w : w * width + u, cover);
    }
  }

  @Override
  public void disc(double x, double y, double radius) {
    double r = radius * scale;
    if (r < TINY) {
      square(x, y, radius * SQUARED);
      return;
    }
    double cx = device(x);
    double cy = device(y);
    for (int j = first(cy - r - 0.5, top, bottom); j <= last(cy + r + 0.5, bottom); j++) {
      for (int i = first(cx - r - 0.5, left, right); i <= last(cx + r + 0.5, right); i++) {
        mix(j * width + i, Math.min(1, r + 0.5 - distance(i - cx, j - cy)));
      }
    }
  }

  @Override
  public void ring(double x, double y, double radius) {
    double cx = device(x);
    double cy = device(y);
    double r = radius * scale;
    double outer = r + lineWidth;
    double most = Math.min(1, lineWidth);
    for (int j = first(cy - outer, top, bottom); j <= last(cy + outer, bottom); j++) {
      for (int i = first(cx - outer, left, right); i <= last(cx + outer, right); i++) {
        double off = Math.abs(distance(i - cx, j - cy) - r);
        mix(j * width + i, Math.min(most, lineWidth / 2 + 0.5 - off));
      }
    }
  }

  private static double distance(double dx, double dy) {
    return Math.sqrt(dx * dx + dy * dy);
  }

  @Override
  public void rectangle(double x, double y, double w, double h) {
    double west = device(x);
    double upper = device(y);
    double east = west + w * scale;
    double lower = upper + h * scale;
    for (int j = first(upper, top, bottom); j <= last(lower, bottom); j++) {
      double rows = Math.min(j + 0.5, lower) - Math.max(j - 0.5, upper);
      for (int i = first(west, left, right); i <= last(east, right); i++) {
        double columns = Math.min(i + 0.5, east) - Math.max(i - 0.5, west);
        mix(j * width + i, rows * columns);
      }
    }
  }

  /**
   * Its rim is not smoothed: its boundary is drawn over it. Each edge changes, in the rows that it
   * crosses, what the pixels to its right belong to.
   */
  @Override
  public void polygon(double[] x, double[] y) {
    boolean[] changes = new boolean[(right - left) * (bottom - top)];
    for (int i = 0, last = x.length - 1; i < x.length; last = i, i++) {
      change(changes, device(x[last]), device(y[last]), device(x[i]), device(y[i]));
    }
    int k = 0;
    for (int row = top; row < bottom; row++) {
      boolean inside = false;
      for (int column = left; column < right; column++) {
        inside ^= changes[k++];
        if (inside) {
          pixels[row * width + column] = rgb;
        }
      }
    }
  }

  private void change(boolean[] changes, double x1, double y1, double x2, double y2) {
    double slope = (x2 - x1) / (y2 - y1);
    double end = Math.min(bottom, Math.max(y1, y2));
    for (int j = (int) Math.ceil(Math.max(top, Math.min(y1, y2))); j < end; j++) {
      int column = (int) Math.ceil(Math.max(left, x1 + slope * (j - y1)));
      if (column < right) {
        changes[(j - top) * (right - left) + column - left] ^= true;
      }
    }
  }

  /** The first pixel of a range that reaches beyond this place. */
  private static int first(double value, int low, int high) {
    return (int) Math.max(low, Math.min(high, Math.floor(value + 0.5)));
  }

  /** The last pixel below the end of a range that begins before this place. */
  private static int last(double value, int high) {
    return (int) Math.max(-1, Math.min(high - 1.0, Math.ceil(value - 0.5)));
  }

  /** Letters begin at whole pixels, as sharp as the platform's. */
  @Override
  public void text(double x, double y, Anchor anchor, double size, String text) {
    int[] codes = text.codePoints().toArray();
    Letters letters = Letters.of(size, scale);
    int advance = 0;
    for (int code : codes) {
      advance += letters.letter(code).advance;
    }
    double before =
        switch (anchor) {
          case START -> 0;
          case MIDDLE -> advance / 2.0;
          case END -> advance;
        };
    long first = Math.round(device(x) - before);
    long baseline = Math.round(device(y));
    int ink = rgb;
    rgb = Ink.BACKGROUND.rgb(theme);
    letters(letters, codes, first, baseline, true);
    rgb = ink;
    letters(letters, codes, first, baseline, false);
  }

  private void letters(Letters letters, int[] codes, long first, long baseline, boolean rims) {
    long x = first;
    for (int code : codes) {
      Letters.Letter letter = letters.letter(code);
      mask(letter.box, rims ? letter.rim : letter.ink, x, baseline);
      x += letter.advance;
    }
  }

  private void mask(Rectangle box, byte[] covered, long x, long y) {
    for (int row = 0; row < box.height; row++) {
      long j = y + box.y + row;
      for (int column = 0; column < box.width && j >= top && j < bottom; column++) {
        long i = x + box.x + column;
        if (i >= left && i < right) {
          mix((int) (j * width + i), (covered[row * box.width + column] & 0xFF) / 255.0);
        }
      }
    }
  }

  /** Mixes the colour into pixel k, by the part of it that is covered. */
  private void mix(int k, double part) {
    int parts = (int) (part * 256 + 0.5);
    if (parts > 0) {
      int old = pixels[k];
      int rest = 256 - parts;
      // Red and blue share one product: eight bits lie free between them.
      int redBlue = ((old & 0xFF00FF) * rest + (rgb & 0xFF00FF) * parts) >>> 8;
      int green = ((old & 0x00FF00) * rest + (rgb & 0x00FF00) * parts) >>> 8;
      pixels[k] = (redBlue & 0xFF00FF) | (green & 0x00FF00);
    }
  }
}
