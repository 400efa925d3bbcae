package dct.io.format;

import java.io.IOException;

/** A format cannot hold a drawing; the message says why and what would. */
public final class CannotHold extends IOException {
  private static final long serialVersionUID = 1L;

  /** Says what it lacks, as {@code it holds no flips; choose .json}. */
  public CannotHold(String why) {
    super(why);
  }
}
