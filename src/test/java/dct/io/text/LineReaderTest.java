package dct.io.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.FilterReader;
import java.io.IOException;
import java.io.StringReader;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Each piece lies on one line, whose number is known, wherever blocks and buffers end. */
class LineReaderTest {
  @Test
  void numbersTheLineOfEachPiece() throws IOException {
    LineReader lines = new LineReader(new StringReader("ab\n\ncde\r\nf"));
    assertThat(pieces(lines, 2)).isEqualTo("1ab|1\n|2\n|3cd|3e\r|3\n|4f|");
    assertThat(lines.read(new char[1], 0, 1)).isEqualTo(-1);
  }

  @Test
  void aLineMayBeLongerThanABlock() throws IOException {
    String text = "x".repeat(200_000) + "\n" + "y".repeat(65_535) + "\nz";
    LineReader lines = new LineReader(new StringReader(text));
    char[] buffer = new char[300_000];
    assertThat(lines.read(buffer, 0, buffer.length)).isEqualTo(200_001);
    assertThat(lines.read(buffer, 0, buffer.length)).isEqualTo(65_536);
    assertThat(lines.line()).isEqualTo(2);
    assertThat(lines.read(buffer, 0, buffer.length)).isEqualTo(1);
    assertThat(lines.line()).isEqualTo(3);
  }

  @Test
  void shortReadsBelowChangeNothing() throws IOException {
    String text = "one\n\n two\nthree\n".repeat(50);
    String expected = pieces(new LineReader(new StringReader(text)), 3);
    assertThat(pieces(new LineReader(new ShortReads(text)), 3)).isEqualTo(expected);
  }

  @Test
  void goesOnBehindTheLine() throws IOException {
    LineReader lines = new LineReader(new StringReader("a\n \n\n b\n "));
    lines.endAtLine();
    assertThat(pieces(lines, 8)).isEqualTo("1a\n|");
    assertThat(lines.goOn()).isEqualTo('b');
    assertThat(lines.line()).isEqualTo(4);
    assertThat(pieces(lines, 8)).isEqualTo("4b\n|5 |");
    assertThat(lines.goOn()).isEqualTo(-1);
  }

  /** All pieces, each behind the number of its line. */
  private static String pieces(LineReader lines, int length) throws IOException {
    StringBuilder pieces = new StringBuilder();
    char[] buffer = new char[length];
    for (int read = lines.read(buffer, 0, length); read >= 0; ) {
      pieces.append(lines.line()).append(buffer, 0, read).append('|');
      read = lines.read(buffer, 0, length);
    }
    return pieces.toString();
  }

  /** Gives a few characters at a time, sometimes none. */
  private static final class ShortReads extends FilterReader {
    private final Random random = new Random(1);

    ShortReads(String text) {
      super(new StringReader(text));
    }

    @Override
    public int read(char[] text, int from, int length) throws IOException {
      return super.read(text, from, Math.min(length, random.nextInt(6)));
    }
  }
}
