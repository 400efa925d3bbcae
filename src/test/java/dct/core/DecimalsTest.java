package dct.core;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DecimalsTest {

  @ParameterizedTest
  @CsvSource({
    "0, 0",
    "-3, -3",
    "1000000, 1000000",
    "9007199254740993, 9007199254740992",
    "0.1, 0.1",
    "-12.345, -12.345",
    "3.7974166882130675, 3.7974166882130675",
    "0.30000000000000004, 0.30000000000000004",
    "1e20, 100000000000000000000",
    "1e21, 1e21",
    "8.41e21, 8.41e21",
    "2e23, 2e23",
    "1e-7, 0.0000001",
    "2.5e-8, 2.5e-8",
    "0.00012345, 0.00012345",
    "4.9e-324, 5e-324",
    "1.7976931348623157e308, 1.7976931348623157e308",
    "123456789.98765433, 123456789.98765433",
    "999.9999999999999, 999.9999999999999",
    "1000.0000000000001, 1000.0000000000001",
    "0.000012345678901234568, 0.000012345678901234568",
    "2251799813685249.5, 2251799813685249.5",
    "9007199254740991, 9007199254740991",
    "0.1234567890123, 0.1234567890123",
    "0.00001, 0.00001",
  })
  void writes_the_shortest_decimal(double value, String text) {
    assertThat(Decimals.format(value)).isEqualTo(text);
  }

  @Test
  void reads_back_every_double_that_it_writes() {
    SeededRandom random = new SeededRandom(11);
    for (int i = 0; i < 10_000; i++) {
      double bits = Double.longBitsToDouble(random.nextLong());
      assertRoundTrip(Double.isFinite(bits) ? bits : i);
      assertRoundTrip(random.nextDouble() * 1000);
      assertRoundTrip(random.nextDouble() * Math.scalb(1.0, random.nextInt(80) - 25));
      assertRoundTrip(Math.nextUp(Math.scalb(1.0, random.nextInt(80) - 25)));
      assertRoundTrip(random.nextInt(1_000_000_000) / 1000.0);
      assertRoundTrip(random.nextInt(1_000_000) * 1e-11);
    }
  }

  private static void assertRoundTrip(double value) {
    String text = Decimals.format(value);
    assertThat(Double.parseDouble(text)).as(text).isEqualTo(value);
    assertThat(Decimals.parse(text)).as(text).isEqualTo(value);
    assertThat(digits(text)).as(text).isLessThanOrEqualTo(digits(Double.toString(value)));
  }

  private static long digits(String number) {
    String mantissa = number.replaceAll("[eE].*|[-.]", "");
    return mantissa.replaceAll("^0+|0+$", "").length();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "0",
        "-0",
        "+7",
        "7.",
        ".5",
        "-.5",
        "00012",
        "1e3",
        "1E-3",
        "1.5e+2",
        "0.1",
        "0.7",
        "123456789012345",
        "1234567890123456",
        "9007199254740993",
        "0.000000000000000000000001",
        "179769313486231580793728971405301e275",
        "2.2250738585072011e-308",
        "1e-400",
        "1e23",
        "8.5e22",
        "4503599627370497.5",
        "0.1000000000000000055511151231257827021181583404541015625"
      })
  void reads_numbers_correctly_rounded(String text) {
    assertThat(Decimals.parse(text)).isEqualTo(Double.parseDouble(text));
  }

  @Test
  void reads_random_decimals_correctly_rounded() {
    SeededRandom random = new SeededRandom(12);
    for (int i = 0; i < 10_000; i++) {
      String whole = Long.toString(random.nextLong() >> random.nextInt(63));
      String text = whole + "." + (random.nextLong() >>> (1 + random.nextInt(62)));
      assertThat(Decimals.parse(text)).as(text).isEqualTo(Double.parseDouble(text));
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "-",
        "+",
        ".",
        "-.",
        "e5",
        "1e",
        "1e+",
        "1.2.3",
        "1-2",
        "--1",
        "1e5.0",
        "0x10",
        "NaN",
        "Infinity",
        "1d",
        "1f",
        "1_000",
        "abc",
        "1e5x",
        "٣"
      })
  void refuses_what_is_not_a_decimal_number(String text) {
    assertThat(Decimals.parse(text)).isNaN();
  }

  @Test
  void numbers_beyond_the_doubles_are_infinite() {
    assertThat(Decimals.parse("1e400")).isInfinite();
    assertThat(Decimals.parse("-1" + "0".repeat(400))).isInfinite();
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0",
    "-0.004, 0",
    "1.005, 1",
    "0.125, 0.12",
    "0.375, 0.38",
    "-2.5, -2.5",
    "100, 100",
    "1e22, 10000000000000000000000",
    "1e-300, 0",
  })
  void rounds_to_two_places_half_to_even(double value, String text) {
    assertThat(Decimals.rounded(value)).isEqualTo(text);
  }

  @Test
  void says_that_a_number_is_not_finite() {
    assertThat(Decimals.format(Double.NEGATIVE_INFINITY)).isEqualTo("-Infinity");
    assertThat(Decimals.format(Double.NaN)).isEqualTo("NaN");
  }
}
