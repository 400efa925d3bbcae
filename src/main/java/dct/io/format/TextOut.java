package dct.io.format;

import dct.core.Decimals;
import dct.core.Progress;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/** Text that is written to a stream in blocks; every number reads back to the same double. */
public final class TextOut {
  private static final int BLOCK = 1 << 15;

  private final OutputStream out;
  private final Progress progress;
  private final StringBuilder text = new StringBuilder();

  /** Text for a stream; it is complete after {@link #flush}. */
  public TextOut(OutputStream out, Progress progress) {
    this.out = out;
    this.progress = progress;
  }

  /** Adds a text. */
  public TextOut add(String following) throws IOException {
    text.append(following);
    return room();
  }

  /** Adds a whole number. */
  public TextOut add(int number) throws IOException {
    text.append(number);
    return room();
  }

  /** Adds a number in as few digits as tell it from all others. */
  public TextOut add(double number) throws IOException {
    Decimals.append(text, number);
    return room();
  }

  /**
   * Says how far the writing is.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public void tick(int step, int steps) {
    Progress.tick(progress, step, steps, "Writing");
  }

  private TextOut room() throws IOException {
    if (text.length() >= BLOCK) {
      flush();
    }
    return this;
  }

  /** Writes what has been added. */
  public void flush() throws IOException {
    out.write(text.toString().getBytes(StandardCharsets.UTF_8));
    text.setLength(0);
  }
}
