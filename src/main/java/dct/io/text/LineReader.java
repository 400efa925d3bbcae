package dct.io.text;

import java.io.IOException;
import java.io.Reader;

/**
 * Gives its characters at most a line at a time, so that its caller knows the line that they are
 * in, however it buffers. It reads in blocks of its own: nothing need be buffered below it.
 */
public final class LineReader extends Reader {
  private final Reader in;
  private final char[] block = new char[1 << 16];
  private int next; // the first character of the block that was not given
  private int filled; // characters of the block in use
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
      if (!isMore()) {
        return i == from ? -1 : i - from;
      }
      int end = endOfLine(from + length - i);
      System.arraycopy(block, next, text, i, end - next);
      i += end - next;
      giveTo(end);
    }
    return i - from;
  }

  /** Whether there is another character, which is in the block then. */
  private boolean isMore() throws IOException {
    while (next == filled) {
      int read = in.read(block, 0, block.length);
      if (read < 0) {
        return false;
      }
      next = 0;
      filled = read;
    }
    return true;
  }

  /** Where the line ends in the block, behind at most so many characters. */
  private int endOfLine(int most) {
    int to = Math.min(filled, next + most);
    int i = next;
    while (i < to && block[i] != '\n') {
      i++;
    }
    return Math.min(i + 1, to);
  }

  /** Gives what stands before a place in the block and is of one line. */
  private void giveTo(int end) {
    line += atLineEnd ? 1 : 0;
    atLineEnd = block[end - 1] == '\n';
    next = end;
  }

  /** Gives no more than the rest of the line, until {@link #goOn}. */
  void endAtLine() {
    endsAtLine = true;
  }

  /** Goes on behind the line; gives the next character that is no blank, which stays, or −1. */
  int goOn() throws IOException {
    endsAtLine = false;
    while (isMore() && block[next] <= ' ') {
      giveTo(next + 1);
    }
    if (next == filled) {
      return -1;
    }
    line += atLineEnd ? 1 : 0;
    atLineEnd = false;
    return block[next];
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
