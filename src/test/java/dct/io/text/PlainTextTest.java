package dct.io.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PlainTextTest {
  private static final String TEXT = "0 0\n1 0 # ä 😀\n".repeat(3000);

  private static String read(byte[] bytes) throws IOException {
    byte[] text = PlainText.of("in", new ByteArrayInputStream(bytes)).readAllBytes();
    return new String(text, StandardCharsets.UTF_8);
  }

  private static byte[] packed(byte[] bytes) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (GZIPOutputStream gzip = new GZIPOutputStream(out)) {
      gzip.write(bytes);
    }
    return out.toByteArray();
  }

  @ParameterizedTest
  @ValueSource(strings = {"UTF-8", "UTF-16LE", "UTF-16BE"})
  void a_mark_tells_the_encoding_and_is_left_out_packed_or_not(String encoding) throws IOException {
    byte[] bytes = ("\uFEFF" + TEXT).getBytes(Charset.forName(encoding));
    assertThat(read(bytes)).isEqualTo(TEXT);
    assertThat(read(packed(bytes))).isEqualTo(TEXT);
  }

  @Test
  void text_without_a_mark_is_given_as_it_is() throws IOException {
    assertThat(read(TEXT.getBytes(StandardCharsets.UTF_8))).isEqualTo(TEXT);
    assertThat(read(new byte[0])).isEmpty();
    assertThat(read(new byte[] {'x'})).isEqualTo("x");
  }

  @Test
  void damaged_packages_are_told_in_a_sentence() throws IOException {
    byte[] whole = packed(TEXT.getBytes(StandardCharsets.UTF_8));
    byte[] cut = Arrays.copyOf(whole, whole.length / 2);
    byte[] changed = whole.clone();
    changed[whole.length - 6] ^= 1; // the checksum
    for (byte[] bytes : new byte[][] {cut, changed, {0x1F, (byte) 0x8B}, {0x1F, (byte) 0x8B, 1}}) {
      assertThatThrownBy(() -> read(bytes))
          .isInstanceOf(BadInputException.class)
          .hasMessage("in: it is packed by gzip, but damaged or not whole; fetch it again");
    }
  }
}
