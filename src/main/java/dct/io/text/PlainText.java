package dct.io.text;

import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;

/**
 * The text of a file in UTF-8 without a byte-order mark: unpacked where it is packed by gzip, and
 * recoded where a mark says that it is UTF-16.
 */
public final class PlainText {
  private static final int MARK = 4;

  private PlainText() {}

  /**
   * The text of a stream.
   *
   * @param name what messages call it
   * @throws BadInputException also while reading, if it starts as gzip does and is not or ends
   *     early
   */
  public static InputStream of(String name, InputStream packed) throws IOException {
    BufferedInputStream in = new BufferedInputStream(packed);
    BufferedInputStream text = isGzip(start(in)) ? unpacked(name, in) : in;
    byte[] start = start(text);
    if (has(start, 0xEF, 0xBB, 0xBF)) {
      text.skipNBytes(3);
      return text;
    }
    boolean is32 = has(start, 0xFF, 0xFE, 0, 0); // which a line of text is refused for
    if (has(start, 0xFE, 0xFF) || (has(start, 0xFF, 0xFE) && !is32)) {
      return new Recoded(new InputStreamReader(text, StandardCharsets.UTF_16));
    }
    return text;
  }

  private static byte[] start(BufferedInputStream in) throws IOException {
    in.mark(MARK);
    byte[] start = in.readNBytes(MARK);
    in.reset();
    return start;
  }

  private static boolean isGzip(byte[] start) {
    return has(start, 0x1F, 0x8B);
  }

  private static boolean has(byte[] start, int... mark) {
    if (start.length < mark.length) {
      return false;
    }
    for (int i = 0; i < mark.length; i++) {
      if ((start[i] & 0xFF) != mark[i]) {
        return false;
      }
    }
    return true;
  }

  private static BufferedInputStream unpacked(String name, InputStream in) throws IOException {
    try {
      return new BufferedInputStream(new Unpacked(name, new GZIPInputStream(in, 1 << 16)));
    } catch (ZipException | EOFException e) {
      throw damaged(name);
    }
  }

  private static BadInputException damaged(String name) {
    return new BadInputException(
        name, 0, "it is packed by gzip, but damaged or not whole; fetch it again");
  }

  /** A packed stream whose damage is said in a sentence. */
  private static final class Unpacked extends InputStream {
    private final String name;
    private final GZIPInputStream in;

    Unpacked(String name, GZIPInputStream in) {
      this.name = name;
      this.in = in;
    }

    @Override
    public int read() throws IOException {
      byte[] one = new byte[1];
      return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
    }

    @Override
    public int read(byte[] bytes, int from, int length) throws IOException {
      try {
        return in.read(bytes, from, length);
      } catch (ZipException | EOFException e) {
        throw damaged(name);
      }
    }
  }

  /** Characters as UTF-8. */
  private static final class Recoded extends InputStream {
    private static final Charset TO = StandardCharsets.UTF_8;

    private final Reader in;
    private byte[] bytes = new byte[0];
    private int next;

    Recoded(Reader in) {
      this.in = in;
    }

    @Override
    public int read() throws IOException {
      return next < bytes.length || fill() ? bytes[next++] & 0xFF : -1;
    }

    @Override
    public int read(byte[] to, int from, int length) throws IOException {
      if (next == bytes.length && !fill()) {
        return -1;
      }
      int given = Math.min(length, bytes.length - next);
      System.arraycopy(bytes, next, to, from, given);
      next += given;
      return given;
    }

    /** Fills the buffer with whole characters. */
    private boolean fill() throws IOException {
      char[] text = new char[1 << 13];
      int read = in.read(text, 0, text.length - 1);
      if (read < 0) {
        return false;
      }
      if (Character.isHighSurrogate(text[read - 1])) {
        int second = in.read();
        text[read] = second < 0 ? 0xFFFD : (char) second;
        read++;
      }
      bytes = new String(text, 0, read).getBytes(TO);
      next = 0;
      return true;
    }
  }
}
