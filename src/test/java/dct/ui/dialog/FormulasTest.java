package dct.ui.dialog;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Where a text with formulas may be wrapped. */
class FormulasTest {

  @Test
  void aFormulaIsOneWord() {
    assertThat(
            Formulas.unbroken("Counting sides, 3 × black = 3 × white + 12: 3 would divide it.")
                .split(" "))
        .containsExactly(
            "Counting",
            "sides,",
            "3\u00a0×\u00a0black\u00a0=\u00a03\u00a0×\u00a0white\u00a0+\u00a012:",
            "3",
            "would",
            "divide",
            "it.");
  }

  @Test
  void theLettersOfAFormulaMayBeSigns() {
    assertThat(Formulas.unbroken("a + b × c − 3 = d")).doesNotContain(" ");
  }

  @Test
  void otherTextIsAsItWas() {
    String text = "A well-known set – of sites: v3→v4, +2 even · odd 1.\n\nAs 4 of them.";
    assertThat(Formulas.unbroken(text)).isEqualTo(text);
  }
}
