package dct.io.text;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;

/**
 * The lines of a stream of bytes, one at a time, without a string for each.
 *
 * <p>A line ends with LF, CR LF, CR or the stream. A byte-order mark of UTF-8 is skipped. A line
 * may be {@value #LONGEST} bytes long, or as long as is said; of a longer one that much is given
 * and {@link #isCut} says so.
 */
public final class ByteLines {
  public static final int LONGEST = 1 << 16;

  private final InputStream in;
  private final int longest;
  private byte[] buffer = new byte[LONGEST];
  private int start; // of the current line
  private int end; // of the current line, without its end mark
  private int next; // where the next line starts
  private int filled; // bytes of the buffer in use
  private int number;
  private boolean afterCr;
  private boolean cut;

  /** The lines of a stream. */
  public ByteLines(InputStream in) throws IOException {
    this(in, LONGEST);
  }

  /** The lines of a stream, which may be so many bytes long, {@value #LONGEST} or more. */
  public ByteLines(InputStream in, int longest) throws IOException {
    this.in = in;
    this.longest = longest;
    while (filled < 3 && fill()) {
      // a byte-order mark is looked for in the first three bytes
    }
    if (filled >= 3
        && buffer[0] == (byte) 0xEF
        && buffer[1] == (byte) 0xBB
        && buffer[2] == (byte) 0xBF) {
      next = 3;
    }
  }

  /** Goes to the next line, if there is one. */
  public boolean next() throws IOException {
    skipLfAfterCr();
    start = next;
    int i = next;
    while (true) {
      if (i == filled) {
        int before = start;
        if (!makeRoom() || !fill()) {
          return last();
        }
        i -= before - start;
      }
      if (buffer[i] == '\n' || buffer[i] == '\r') {
        afterCr = buffer[i] == '\r';
        return line(i, i + 1);
      }
      i++;
    }
  }

  /** Skips what is left of a line that is cut, which is empty then. */
  public void skipRest() throws IOException {
    while (cut) {
      start = 0;
      next = 0;
      filled = 0;
      cut = fill();
      for (int i = 0; i < filled && cut; i++) {
        if (buffer[i] == '\n' || buffer[i] == '\r') {
          afterCr = buffer[i] == '\r';
          next = i + 1;
          cut = false;
        }
      }
    }
    start = next;
    end = next;
  }

  private void skipLfAfterCr() throws IOException {
    if (!afterCr) {
      return;
    }
    afterCr = false;
    if (next == filled) {
      start = next;
      makeRoom();
      if (!fill()) {
        return;
      }
    }
    if (buffer[next] == '\n') {
      next++;
    }
  }

  /** Moves what has not been given out to the front; false if that is as long as may be. */
  private boolean makeRoom() {
    System.arraycopy(buffer, start, buffer, 0, filled - start);
    filled -= start;
    next -= start;
    start = 0;
    if (filled == buffer.length && filled < longest) {
      buffer = Arrays.copyOf(buffer, (int) Math.min(longest, 2L * filled));
    }
    cut = filled == buffer.length;
    return !cut;
  }

  private boolean fill() throws IOException {
    int read = in.read(buffer, filled, buffer.length - filled);
    filled += Math.max(read, 0);
    return read >= 0;
  }

  private boolean last() {
    return start < filled && line(filled, filled);
  }

  private boolean line(int lineEnd, int following) {
    end = lineEnd;
    next = following;
    number++;
    return true;
  }

  /** The bytes, of which the current line is a part. */
  public byte[] bytes() {
    return buffer;
  }

  /** Where the current line starts. */
  public int start() {
    return start;
  }

  /** Where the current line ends. */
  public int end() {
    return end;
  }

  /** Where the bytes end that have been read so far; some of them follow the current line. */
  public int ahead() {
    return filled;
  }

  /** The number of the current line, from 1 on; 0 before the first. */
  public int number() {
    return number;
  }

  /** Whether the current line is longer than it may be. */
  public boolean isCut() {
    return cut;
  }

  /** White space within a line. */
  public static boolean isBlank(byte b) {
    return b == ' ' || b == '\t' || b == 0x0B || b == '\f';
  }
}
