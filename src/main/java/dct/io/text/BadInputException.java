package dct.io.text;

/**
 * Input that cannot be used.
 *
 * <p>Its message is one line for a person: {@code FILE:LINE: what is wrong; what would mend it}, or
 * without the line where there is none.
 */
public class BadInputException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final String file;
  private final int line;
  private final String fault;

  /**
   * Says what is wrong in a file.
   *
   * @param file the file's name as the user gave it, or "-" for standard input
   * @param line the line, from 1 on; 0 where the file as a whole is meant
   * @param fault what is wrong and, after a semicolon, what would mend it
   */
  public BadInputException(String file, int line, String fault) {
    super(Shown.harmless(file + (line > 0 ? ":" + line : "") + ": " + fault));
    this.file = file;
    this.line = line;
    this.fault = fault;
  }

  /** The file's name as the user gave it. */
  public String file() {
    return file;
  }

  /** The line, from 1 on; 0 where the file as a whole is meant. */
  public int line() {
    return line;
  }

  /** What is wrong and what would mend it, without file and line. */
  public String fault() {
    return fault;
  }
}
