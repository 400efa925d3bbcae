package dct.render;

/** The look of a picture: dark ink on a light ground, or the reverse. */
public enum Theme {
  /** Dark on white: the default. */
  LIGHT,
  /** Bright on near black. */
  DARK,
  /** Dark on white, told apart in grey, too: for paper. */
  PRINT
}
