package dct.io;

import java.io.IOException;
import java.io.Reader;

/**
 * Gives its characters at most a line at a time, so that whoever pulls them knows the line it is
 * in, however it buffers.
 */
final class LineReader extends Reader {
  private final Reader in;
  private int line = 1;
  private boolean atLineEnd;

  LineReader(Reader in) {
    this.in = in;
  }

  @Override
  public int read(char[] text, int from, int length) throws IOException {
    if (atLineEnd) {
      line++;
      atLineEnd = false;
    }
    int i = from;
    while (i < from + length && !atLineEnd) {
      int c = in.read();
      if (c < 0) {
        return i == from ? -1 : i - from;
      }
      text[i++] = (char) c;
      atLineEnd = c == '\n';
    }
    return i - from;
  }

  /** The line of the last character given, from 1 on. */
  int line() {
    return line;
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}
