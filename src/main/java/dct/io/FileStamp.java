package dct.io;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Optional;

/**
 * What a file held at some time, by its SHA-256: whether someone has written to it since can be
 * told, whatever its date says.
 *
 * @param digest in hexadecimal digits
 */
public record FileStamp(String digest) {
  private static final int BLOCK = 1 << 16;

  /**
   * The stamp of a file as it is now, in one reading.
   *
   * @return nothing if there is no such file, or it cannot be read
   */
  public static Optional<FileStamp> of(Path file) {
    if (!Files.isRegularFile(file)) {
      return Optional.empty();
    }
    try (InputStream in = Files.newInputStream(file)) {
      return Optional.of(new FileStamp(digest(in)));
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  private static String digest(InputStream in) throws IOException {
    MessageDigest digest = sha256();
    byte[] block = new byte[BLOCK];
    for (int count = in.read(block); count >= 0; count = in.read(block)) {
      digest.update(block, 0, count);
    }
    return HexFormat.of().formatHex(digest.digest());
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e); // every Java has it
    }
  }
}
