package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import dct.core.Progress;
import dct.io.text.BadInputException;
import java.io.ByteArrayInputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Text that holds no points: one sentence with file, line, cause and cure. */
class BadTextTest {
  private static final String FORM = "write one vertex a line, as two numbers x y";

  private static String fault(byte[] bytes) {
    BadInputException bad =
        catchThrowableOfType(
            BadInputException.class,
            () -> PointFile.read("in.txt", new ByteArrayInputStream(bytes)));
    assertThat(bad).as("nothing was found wrong").isNotNull();
    assertThat(bad.file()).isEqualTo("in.txt");
    assertThat(bad).hasMessage("in.txt:" + bad.line() + ": " + bad.fault());
    return bad.line() + ": " + bad.fault();
  }

  private static String fault(String text) {
    return fault(text.getBytes(StandardCharsets.UTF_8));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "abc 2 | \"abc\" is not a number; FORM",
        "2 abc # x | \"abc\" is not a number; FORM",
        "1 2 c | \"c\" is not a number; FORM",
        "1#2 3 | \"1#2\" is not a number; leave a blank before #, or FORM",
        "1 -1.#IND | -1.#IND is not a finite number; remove the line or correct the coordinate",
        "1.#INF00 1 | 1.#INF00 is not a finite number; remove the line or correct the coordinate",
        "1,000 2 | 1,000 can mean 1000 or 1.000; write which, without a comma",
        "1,000 2,5 | 1,000 is written with a decimal comma; write it with a point, 1.000",
        "1,000,000 2 | 1,000,000 has commas between thousands; write it as 1000000",
        "1d 2 | \"1d\" is not a number; FORM",
        "1 | there is only one number; FORM",
        "1, | there is only one number; FORM",
        "',1 2' | a number is missing beside a comma or semicolon; FORM",
        "'1,,2' | a number is missing beside a comma or semicolon; FORM",
        "'1 2;;' | a number is missing beside a comma or semicolon; FORM",
        "NaN 1 | NaN is not a finite number; remove the line or correct the coordinate",
        "1 nan | nan is not a finite number; remove the line or correct the coordinate",
        "1 Infinity | Infinity is not a finite number; remove the line or correct the coordinate",
        "-inf 1 | -inf is not a finite number; remove the line or correct the coordinate",
        "1e400 1 | 1e400 is too large, a coordinate is at most 1.797e308; scale the data",
        "1 -1e400 | -1e400 is too large, a coordinate is at most 1.797e308; scale the data",
        "0x10 1 | 0x10 is hexadecimal; write the number in decimal",
        "1 -0X1p3 | -0X1p3 is hexadecimal; write the number in decimal",
        "1,5 2,5 | 1,5 is written with a decimal comma; write it with a point, 1.5",
        "1,5;2,5 | 1,5 is written with a decimal comma; write it with a point, 1.5",
        "1,5; 2 | 1,5 is written with a decimal comma; write it with a point, 1.5",
        "1\t-2,25e3 | -2,25e3 is written with a decimal comma; write it with a point, -2.25e3",
        "1.000,5 7 | 1.000,5 is written with a decimal comma; write it with a point, 1000.5",
      })
  void names_what_is_wrong_in_a_line(String line, String fault) {
    String expected = fault.replace("FORM", FORM);
    assertThat(fault("# head\n0 0\n\n1 1\n" + line + "\n2 2\n")).isEqualTo("5: " + expected);
    assertThat(fault(line)).isEqualTo("1: " + expected);
  }

  @Test
  void a_row_of_another_width() {
    assertThat(fault("# head\n0 0\n\n1 2 3\n"))
        .isEqualTo("4: there are 3 numbers here, but 2 in line 2; " + FORM);
    assertThat(fault("0 0 1\n1 2\n"))
        .isEqualTo("2: there are 2 numbers here, but 3 in line 1; " + FORM);
  }

  @Test
  void an_empty_file() {
    assertThat(fault("")).isEqualTo("1: the file is empty; " + FORM);
    assertThat(fault("\uFEFF")).isEqualTo("1: the file is empty; " + FORM);
    assertThat(fault("# only\n# comments\n"))
        .isEqualTo("2: there is no vertex in the file; " + FORM);
  }

  @Test
  void a_binary_file() {
    String binary = "this is a binary file, not text; choose a file with two numbers x y a line";
    assertThat(fault(new byte[1000])).isEqualTo("1: " + binary);
    assertThat(fault(new byte[1_000_000])).isEqualTo("1: " + binary);
    assertThat(fault("1 2\n3 4\n\0\0")).startsWith("3: here are only zero bytes, ");
    assertThat(fault("1 2\n3 4\n\u001A")).startsWith("3: the line holds Ctrl-Z, ");
    assertThat(fault("1 2\n3 4\na\0")).isEqualTo("3: " + binary);
    assertThat(fault("1 2\n3 x\n5 6\n\0\0")).as("the first fault").startsWith("2: \"x\" is not");
    assertThat(fault("# \0\n1 2\n")).isEqualTo("1: " + binary);
    byte[] png = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n', 0, 0, 0, 0x0D};
    assertThat(fault(png)).isEqualTo("1: " + binary);
  }

  @Test
  void another_encoding() {
    String latin1 = "byte 0xE4 is not UTF-8, the text may be Latin-1; save it as UTF-8";
    Charset latin = StandardCharsets.ISO_8859_1;
    assertThat(fault("0 0\n1 2ä\n".getBytes(latin))).isEqualTo("2: " + latin1);
    assertThat(fault("0 0\n1 2 # ä\n".getBytes(latin))).isEqualTo("2: " + latin1);
    assertThat(fault("# ä\n1 2\n".getBytes(latin))).isEqualTo("1: " + latin1);
    for (String name : new String[] {"UTF-16LE", "UTF-16BE", "UTF-32LE", "UTF-32BE"}) {
      for (String mark : name.contains("32") ? new String[] {"\uFEFF", ""} : new String[] {""}) {
        assertThat(fault((mark + "10 20\n3 4\n").getBytes(Charset.forName(name))))
            .isEqualTo("1: the text is encoded in " + name.substring(0, 6) + "; save it as UTF-8");
      }
    }
  }

  @Test
  void the_message_stays_short_whatever_the_file_holds() {
    assertThat(fault("x".repeat(1000) + " 1\n"))
        .isEqualTo("1: \"" + "x".repeat(40) + "…\" is not a number; " + FORM);
    assertThat(fault("1 2\n" + "x".repeat(10_000_000)))
        .isEqualTo("2: the line is longer than 65536 bytes; " + FORM);
    assertThat(fault("ä".repeat(40_000)))
        .isEqualTo("1: the line is longer than 65536 bytes; " + FORM);
    assertThat(fault("garbage\n".repeat(1_000_000)))
        .isEqualTo("1: \"garbage\" is not a number; " + FORM);
  }

  /** Each long line is refused in one pass over it, and without a call for each character. */
  @ParameterizedTest
  @ValueSource(strings = {"1", "1.", "C", "ST", "a,", "\"a\",", "a\t\t\t", "1 ", "1\u00A0234"})
  void a_long_line_of_the_same_again_and_again(String part) {
    String line = part.repeat(32_000 / part.length());
    assertThat(fault("1 2\n1" + " ".repeat(32_000) + "!")).startsWith("2: ");
    assertThat(fault("1 2\n1" + line + "!")).startsWith("2: ").hasSizeLessThan(300);
    assertThat(fault(line + "!\n1 2 3\n")).hasSizeLessThan(300);
  }

  @Test
  void commas_alone_are_no_header() {
    assertThat(fault(",\n1 2\n"))
        .isEqualTo("1: a number is missing beside a comma or semicolon; " + FORM);
  }

  @Test
  void a_file_that_cannot_be_read(@TempDir Path folder) {
    Path missing = folder.resolve("missing.txt");
    assertThat(openingFault(missing))
        .isEqualTo(missing + ": there is no such file; check its name and folder");
    assertThat(openingFault(folder)).isEqualTo(folder + ": this is a folder; name a file in it");
    assertThat(openingFault(missing.resolve("below.txt")))
        .isEqualTo(missing + "/below.txt: there is no such file; check its name and folder");
    assertThat(Files.exists(missing)).isFalse();
  }

  private static String openingFault(Path file) {
    return catchThrowableOfType(BadInputException.class, () -> PointFile.read(file, Progress.NONE))
        .getMessage();
  }

  @Test
  void nothing_of_a_file_or_its_name_acts_on_the_terminal() {
    BadInputException bad =
        catchThrowableOfType(
            BadInputException.class,
            () ->
                PointFile.read(
                    "a\u001B[31m\nb",
                    new ByteArrayInputStream("x\u007F\u2066 1".getBytes(StandardCharsets.UTF_8))));
    assertThat(bad)
        .hasMessageStartingWith("a<U+001B>[31m<U+000A>b:1: \"x<U+007F><U+2066>\" is not a number");
    assertThat(new CannotWriteException("a\u0007", "x", null))
        .hasMessageStartingWith("a<U+0007>: ");
  }

  @Test
  void json_that_is_something_else() {
    assertThat(fault("{\"type\": \"Feature\", \"geometry\": null}\n"))
        .isEqualTo(
            "1: there is no geometry with points in this GeoJSON; write \"type\": \"Polygon\","
                + " \"coordinates\": [[[x, y], …]]");
    assertThat(fault("{\"a\": " + "[".repeat(300))).as("a short place").hasSizeLessThan(120);
    assertThat(fault("{ ; }")).isEqualTo("1: this is not JSON; correct it");
  }
}
