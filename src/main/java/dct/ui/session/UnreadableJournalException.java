package dct.ui.session;

import java.io.IOException;

/** A journal of another version of the program, or one that is damaged from its beginning. */
final class UnreadableJournalException extends IOException {
  private static final long serialVersionUID = 1L;

  UnreadableJournalException() {
    super("this is no journal of this version of the program");
  }
}
