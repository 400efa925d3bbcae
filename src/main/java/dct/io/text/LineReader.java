package dct.io.text;

import java.io.IOException;
import java.io.Reader;

/**
 * Gives its characters at most a line at a time, so that its caller knows the line that they are
 * in, however it buffers.
 */
public final class LineReader extends Reader {
  private final Reader in;
  private int line = 1;
  private boolean atLineEnd;

  public LineReader(Reader in) {
    this.in = in;
  }

  @Override
  public int read(char[] text, int from, int length) throws IOException {
    int i = from;
    while (i < from + length && (i == from || !atLineEnd)) {
      int c = in.read();
      if (c < 0) {
        return i == from ? -1 : i - from;
      }
      line += atLineEnd ? 1 : 0;
      text[i++] = (char) c;
      atLineEnd = c == '\n';
    }
    return i - from;
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
