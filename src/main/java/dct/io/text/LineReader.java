package dct.io.text;

import java.io.IOException;
import java.io.Reader;

/**
 * Gives its characters at most a line at a time, so that its caller knows the line that they are
 * in, however it buffers.
 */
public final class LineReader extends Reader {
  private static final int NONE = -2;

  private final Reader in;
  private int ahead = NONE; // a character that was read and not given
  private int line = 1;
  private boolean atLineEnd;
  private boolean endsAtLine; // whether the end of the line is given as the end of the text

  public LineReader(Reader in) {
    this.in = in;
  }

  @Override
  public int read(char[] text, int from, int length) throws IOException {
    if (endsAtLine && atLineEnd) {
      return -1;
    }
    int i = from;
    while (i < from + length && (i == from || !atLineEnd)) {
      int c = take();
      if (c < 0) {
        return i == from ? -1 : i - from;
      }
      line += atLineEnd ? 1 : 0;
      text[i++] = (char) c;
      atLineEnd = c == '\n';
    }
    return i - from;
  }

  private int take() throws IOException {
    int c = ahead;
    ahead = NONE;
    return c == NONE ? in.read() : c;
  }

  /** Gives no more than the rest of the line, until {@link #goOn}. */
  void endAtLine() {
    endsAtLine = true;
  }

  /** Goes on behind the line; gives the next character that is no blank, which stays, or −1. */
  int goOn() throws IOException {
    endsAtLine = false;
    int c = take();
    while (c >= 0 && c <= ' ') {
      line += atLineEnd ? 1 : 0;
      atLineEnd = c == '\n';
      c = take();
    }
    if (c < 0) {
      return -1;
    }
    line += atLineEnd ? 1 : 0;
    atLineEnd = false;
    ahead = c;
    return c;
  }

  /** The line of the last character given, from 1 on. */
  public int line() {
    return line;
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}
