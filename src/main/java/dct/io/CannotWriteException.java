package dct.io;

import dct.io.format.CannotHold;
import dct.io.text.Shown;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;

/** A file that could not be written; what stood in its place is as it was. */
public final class CannotWriteException extends IOException {
  private static final long serialVersionUID = 1L;

  /**
   * Says which file and why.
   *
   * @param file the file's name as the user gave it
   * @param reason why it failed, in a few words
   */
  public CannotWriteException(String file, String reason, Throwable cause) {
    super(
        Shown.harmless(file)
            + ": cannot be written, "
            + reason
            + "; nothing was changed, choose another place",
        cause);
  }

  /** Says that a format cannot hold what was to be written to a file. */
  public CannotWriteException(String file, CannotHold why) {
    super(Shown.harmless(file) + ": " + why.getMessage(), why);
  }

  /** Why something could not be written, in a few words. */
  public static String reason(IOException e) {
    if (e instanceof CannotWriteException && e.getCause() instanceof IOException cause) {
      return reason(cause);
    }
    if (e instanceof NoSuchFileException) {
      return "its folder does not exist";
    }
    if (e instanceof AccessDeniedException) {
      return "permission is denied";
    }
    if (e instanceof FileAlreadyExistsException || e instanceof NotDirectoryException) {
      return "it is no folder"; // but a folder was to be there
    }
    String reason = e instanceof FileSystemException f ? f.getReason() : e.getMessage();
    return reason == null ? e.getClass().getSimpleName() : reason;
  }
}
