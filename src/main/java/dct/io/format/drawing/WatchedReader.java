package dct.io.format.drawing;

import java.io.IOException;
import java.io.Reader;

/** Characters of which it is known afterwards whether reading them failed, or reached the end. */
final class WatchedReader extends Reader {
  private final Reader in;
  private boolean atEnd;
  private IOException broken;
  private RuntimeException refused;

  WatchedReader(Reader in) {
    this.in = in;
  }

  @Override
  public int read(char[] text, int from, int length) throws IOException {
    try {
      int read = in.read(text, from, length);
      atEnd |= read < 0;
      return read;
    } catch (IOException e) {
      broken = e;
      throw e;
    } catch (RuntimeException e) {
      refused = e;
      throw e;
    }
  }

  /** Whether the end has been asked for. */
  boolean isAtEnd() {
    return atEnd;
  }

  /** Throws what reading failed with, if it did. */
  void rethrow() throws IOException {
    if (broken != null) {
      throw broken;
    }
    if (refused != null) {
      throw refused;
    }
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}
