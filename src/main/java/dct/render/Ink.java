package dct.render;

/**
 * The colours of a picture by what they stand for: one place for the screen and for files.
 *
 * <p>The hues are the thesis's (its Section 4.3): red, blue, green, cyan and magenta. They are
 * darkened on white, and lightened on black, until thin lines can be told apart. For print they
 * differ in how dark they are, too.
 */
public enum Ink {
  /** The ground that everything is drawn on. */
  BACKGROUND(0xFFFFFF, 0x1E1F22, 0xFFFFFF),
  /** The inside of a polygon: a ground that differs little from the other. */
  INSIDE(0xEDF2F9, 0x2A2D33, 0xF4F5F7),
  /** Vertices of even degree: red. */
  EVEN(0xE00A14, 0xFF5A5F, 0xC9501C),
  /** Vertices of odd degree: blue. */
  ODD(0x0A32E6, 0x6E9BFF, 0x0B1F6B),
  /** The outline of a polygon, or the hull of sites. */
  BOUNDARY(0x20242C, 0xD5D8DE, 0x000000),
  /** Diagonals and interior edges: green. */
  DIAGONAL(0x0E9A35, 0x3FCB62, 0x5E7A66),
  /** Diagonals of the decomposition into convex or monotone pieces: cyan. */
  PARTITION(0x0098B8, 0x35DCF5, 0x1C6E8C),
  /** Diagonals made by a flip: magenta. */
  FLIPPED(0xE812D2, 0xFF6BF0, 0x8C1178),
  /** Fixed edges inside a region: ochre. */
  FIXED(0x8A6100, 0xE3B341, 0x5C4100),
  /** Edges and places that keep a polygon from being simple: red. */
  DEFECT(0xD8000C, 0xFF4D4F, 0xB00010),
  /** Rings round vertices that do not have the parity wished: orange. */
  UNMET(0xE25A00, 0xFF9838, 0x9A4A00),
  /** Edges that only the first of two results has: brown. */
  FIRST(0xA65300, 0xFFB45A, 0x7A3D00),
  /** Edges that only the second of two results has: blue. */
  SECOND(0x0A5FD6, 0x6FB1FF, 0x2C5FA8),
  /** Vertices whose degree is not decided yet. */
  VERTEX(0x3C4350, 0xC4C9D4, 0x2B303A),
  /** Words and numbers. */
  LABEL(0x20242C, 0xE4E6EB, 0x000000),
  /** What is only proposed: the edges that the next click would make. */
  PROPOSED(0x7D8798, 0x7E8798, 0x848A94),
  /** What the mouse points at, or what an explanation speaks of. */
  HIGHLIGHT(0xBF7300, 0xFBBF24, 0x8A5300),
  /** The first of three things that an explanation tells apart: brown. */
  MARK_ONE(0x8A5A1E, 0xD9B27A, 0x8A5A1E),
  /** The second: violet. */
  MARK_TWO(0x6B2FB3, 0xB794F6, 0x4B1F85),
  /** The third: dark cyan. */
  MARK_THREE(0x00736B, 0x4DD0C0, 0x00736B);

  private final int light;
  private final int dark;
  private final int print;

  Ink(int light, int dark, int print) {
    this.light = light;
    this.dark = dark;
    this.print = print;
  }

  /** The colour as 0xRRGGBB. */
  public int rgb(Theme theme) {
    return switch (theme) {
      case LIGHT -> light;
      case DARK -> dark;
      case PRINT -> print;
    };
  }
}
