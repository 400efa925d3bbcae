package dct.render;

/** The look of a picture: dark ink on a light ground, or the reverse. */
public enum Theme {
  /** Dark on white: the default, and that of every exported file. */
  LIGHT,
  /** Bright on near black. */
  DARK
}
