package dct.io.format.drawing;

import dct.io.text.BadInputException;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The characters of a file of XML, decoded as its declaration says. */
final class XmlEncoding {
  private static final int DECLARATION = 256; // bytes in which it stands, if it stands anywhere
  private static final Pattern ENCODING =
      Pattern.compile("<\\?xml\\b[^>]*?\\bencoding\\s*=\\s*[\"']([A-Za-z0-9._:-]+)[\"']");

  private XmlEncoding() {}

  /**
   * The characters of a stream.
   *
   * @throws BadInputException if an encoding is named that is not known
   */
  static Reader reader(String name, BufferedInputStream in) throws IOException {
    in.mark(DECLARATION);
    String start = new String(in.readNBytes(DECLARATION), StandardCharsets.ISO_8859_1);
    in.reset();
    Matcher encoding = ENCODING.matcher(start);
    Charset named = encoding.find() ? charset(name, encoding.group(1)) : StandardCharsets.UTF_8;
    return new InputStreamReader(in, named);
  }

  /** The encoding of this name; where the declaration could not be read in it, UTF-8. */
  private static Charset charset(String file, String name) {
    try {
      Charset named = Charset.forName(name);
      String start = new String("<?xml".getBytes(StandardCharsets.US_ASCII), named);
      return start.equals("<?xml") ? named : StandardCharsets.UTF_8;
    } catch (IllegalArgumentException e) {
      throw new BadInputException(
          file, 1, "the encoding " + name + " is not known here; save the file in UTF-8");
    }
  }
}
