package dct.ui.dialog;

import java.util.regex.Pattern;

/** Keeps the formulas of a text on one line each where the text is wrapped. */
public final class Formulas {
  /** Blanks at a sign between two others: 3 × black = 3 × white + 12. */
  private static final Pattern BLANKS = Pattern.compile(" (?=[×+−=<>≤≥] )|(?<= [×+−=<>≤≥]) ");

  private static final String NO_BREAK = "\u00a0";

  private Formulas() {}

  /** The text, its lines not to be broken at the signs of a formula. */
  public static String unbroken(String text) {
    return BLANKS.matcher(text).replaceAll(NO_BREAK);
  }
}
