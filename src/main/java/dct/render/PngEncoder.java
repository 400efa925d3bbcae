package dct.render;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Images as PNG. */
public final class PngEncoder {
  private PngEncoder() {}

  /**
   * Writes an image, which is encoded in memory first: so Java keeps no temporary file, whose
   * closing at the end of the program fails after a failed write.
   *
   * @throws IOException the stream's own, if it fails
   */
  public static void write(BufferedImage image, OutputStream out) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ImageOutputStream encoded = new MemoryCacheImageOutputStream(bytes)) {
      ImageIO.write(image, "png", encoded);
    }
    bytes.writeTo(out);
  }
}
