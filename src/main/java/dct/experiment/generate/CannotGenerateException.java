package dct.experiment.generate;

/** What was asked for cannot be made; the message is one sentence that says why, and a cure. */
public final class CannotGenerateException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  CannotGenerateException(String sentence) {
    super(sentence);
  }
}
