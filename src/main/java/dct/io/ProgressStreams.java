package dct.io;

import dct.core.Progress;
import java.io.FilterInputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** Streams that ask before every block whether to go on. */
final class ProgressStreams {
  private ProgressStreams() {}

  /**
   * A stream that also reports which part of this many bytes has been read. It throws a {@link
   * java.util.concurrent.CancellationException} when cancelled.
   */
  static InputStream reading(InputStream in, long size, Progress progress) {
    return new FilterInputStream(in) {
      private long given;

      @Override
      public int read() throws IOException {
        byte[] one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
      }

      @Override
      public int available() {
        return 0; // which is always true, and of a pipe cannot be asked
      }

      @Override
      public int read(byte[] bytes, int from, int length) throws IOException {
        progress.checkCancelled();
        int read = super.read(bytes, from, length);
        given += Math.max(read, 0);
        progress.report(Math.min(1, (double) given / Math.max(1, size)), "Reading");
        return read;
      }
    };
  }

  /** A stream for large blocks; it throws the same when cancelled. */
  static OutputStream writing(OutputStream out, Progress progress) {
    return new FilterOutputStream(out) {
      @Override
      public void write(byte[] bytes, int from, int length) throws IOException {
        progress.checkCancelled();
        out.write(bytes, from, length);
      }
    };
  }
}
