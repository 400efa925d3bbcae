package dct.cli;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/**
 * The three standard streams of a command, as given; text is UTF-8.
 *
 * @param in standard input
 * @param out standard output
 * @param err standard error
 * @param isTerminal whether a person watches, who may want to know how far a long work is
 */
public record Console(InputStream in, OutputStream out, PrintStream err, boolean isTerminal) {

  /** Streams that no person watches. */
  public Console(InputStream in, OutputStream out, PrintStream err) {
    this(in, out, err, false);
  }

  /** Prints one line on standard output. */
  void print(String line) throws IOException {
    out.write((line + "\n").getBytes(StandardCharsets.UTF_8));
    out.flush();
  }
}
