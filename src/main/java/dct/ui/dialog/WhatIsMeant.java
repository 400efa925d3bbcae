package dct.ui.dialog;

import dct.core.triangulate.Domain;
import dct.io.format.Choice;
import dct.io.format.NoTriangulation;
import dct.io.format.SeveralShapes;
import dct.io.format.UnclearColumns;
import dct.io.format.UnclearInput;
import java.awt.Component;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalInt;

/** Asks what is meant of a file or a text that can be read in more than one way. */
public final class WhatIsMeant {
  private WhatIsMeant() {}

  /**
   * Asks; returns how to read it again, or nothing if it shall not be read.
   *
   * @param before how it has been read
   */
  public static Optional<Choice> ask(
      Component parent, String title, UnclearInput unclear, Choice before) {
    if (unclear instanceof SeveralShapes several) {
      return ShapeChooser.ask(parent, title, several.shapes(), before);
    }
    if (unclear instanceof UnclearColumns columns) {
      return ColumnChooser.ask(parent, title, columns, before);
    }
    return askForPoints(parent, title, (NoTriangulation) unclear, before);
  }

  private static Optional<Choice> askForPoints(
      Component parent, String title, NoTriangulation fault, Choice before) {
    String file = Path.of(fault.file()).getFileName().toString();
    String sentence = file + ", line " + fault.line() + ": " + fault.cause() + ".";
    OptionalInt chosen = Ask.offer(parent, title, sentence, "Open Points Alone");
    return chosen.isPresent() ? Optional.of(before.as(Domain.SITES)) : Optional.empty();
  }
}
