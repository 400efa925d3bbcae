package dct.render;

/**
 * The colours of a picture by what they stand for: one place for the screen and for files.
 *
 * <p>The hues are the thesis's (its Section 4.3): red, blue, green, cyan and magenta. They are
 * darkened on white, and lightened on black, until thin lines can be told apart.
 */
public enum Ink {
  /** The ground that everything is drawn on. */
  BACKGROUND(0xFFFFFF, 0x1E1F22),
  /** The inside of a polygon: a ground that differs little from the other. */
  INSIDE(0xEDF2F9, 0x2A2D33),
  /** Vertices of even degree: red. */
  EVEN(0xE00A14, 0xFF5A5F),
  /** Vertices of odd degree: blue. */
  ODD(0x0A32E6, 0x6E9BFF),
  /** The outline of a polygon, or the hull of sites. */
  BOUNDARY(0x20242C, 0xD5D8DE),
  /** Diagonals and interior edges: green. */
  DIAGONAL(0x0E9A35, 0x3FCB62),
  /** Diagonals of the decomposition into convex or monotone pieces: cyan. */
  PARTITION(0x0098B8, 0x35DCF5),
  /** Diagonals made by a flip: magenta. */
  FLIPPED(0xE812D2, 0xFF6BF0),
  /** Edges and places that keep a polygon from being simple: red. */
  DEFECT(0xD8000C, 0xFF4D4F),
  /** Rings round vertices that do not have the parity wished: orange. */
  UNMET(0xE25A00, 0xFF9838),
  /** Edges that only the first of two results has: brown. */
  FIRST(0xA65300, 0xFFB45A),
  /** Edges that only the second of two results has: blue. */
  SECOND(0x0A5FD6, 0x6FB1FF),
  /** Vertices whose degree is not decided yet. */
  VERTEX(0x3C4350, 0xC4C9D4),
  /** Words and numbers. */
  LABEL(0x20242C, 0xE4E6EB),
  /** What is only proposed: the edges that the next click would make. */
  PROPOSED(0x7D8798, 0x7E8798),
  /** What the mouse points at, or what an explanation speaks of. */
  HIGHLIGHT(0xBF7300, 0xFBBF24),
  /** The first of three things that an explanation tells apart: brown. */
  MARK_ONE(0x8A5A1E, 0xD9B27A),
  /** The second: violet. */
  MARK_TWO(0x6B2FB3, 0xB794F6),
  /** The third: dark cyan. */
  MARK_THREE(0x00736B, 0x4DD0C0);

  private final int light;
  private final int dark;

  Ink(int light, int dark) {
    this.light = light;
    this.dark = dark;
  }

  /** The colour as 0xRRGGBB. */
  public int rgb(Theme theme) {
    return theme == Theme.LIGHT ? light : dark;
  }
}
