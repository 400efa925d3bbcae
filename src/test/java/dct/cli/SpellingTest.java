package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The word that was meant. */
class SpellingTest {
  @ParameterizedTest
  @CsvSource({
    "'', '', 0",
    "even, even, 0",
    "evn, even, 1",
    "evven, even, 1",
    "evan, even, 1",
    "eevn, even, 1",
    "eve, odd, 3",
    "kitten, sitting, 3"
  })
  void slips_are_counted(String typed, String word, int slips) {
    assertThat(Spelling.distance(typed, word)).isEqualTo(slips);
    assertThat(Spelling.distance(word, typed)).isEqualTo(slips);
  }

  @Test
  void only_a_near_word_is_named() {
    List<String> known = List.of("-h", "even", "odd", "uneven");
    assertThat(Spelling.hint("evn", known)).isEqualTo(" (did you mean even?)");
    assertThat(Spelling.hint("uneve", known)).isEqualTo(" (did you mean uneven?)");
    assertThat(Spelling.hint("-x", known)).isEmpty();
    assertThat(Spelling.hint("most", known)).isEmpty();
  }
}
