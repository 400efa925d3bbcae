package dct.ui.shell;

/** No call of the program makes what is shown; the message says why, and what would mend it. */
public final class NotRepeatableException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** An exception with a sentence for a person. */
  public NotRepeatableException(String sentence) {
    super(sentence);
  }
}
