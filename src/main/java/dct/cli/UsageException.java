package dct.cli;

/** A command line that asks for what there is not; the message says what would do. */
final class UsageException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  UsageException(String message) {
    super(message);
  }
}
