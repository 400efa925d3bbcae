package dct.io.format;

import dct.io.text.BadInputException;

/** Input of which more than one thing can be meant; a {@link Choice} says which. */
public abstract sealed class UnclearInput extends BadInputException
    permits SeveralShapes, UnclearColumns, NoTriangulation {
  private static final long serialVersionUID = 1L;

  /** Says what is unclear; the parameters are those of any bad input. */
  UnclearInput(String file, int line, String fault) {
    super(file, line, fault);
  }
}
