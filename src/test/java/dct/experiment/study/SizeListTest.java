package dct.experiment.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class SizeListTest {

  @Test
  void numbers_and_ranges_are_sorted_and_each_there_once() {
    assertThat(SizeList.parse("7", 100)).containsExactly(7);
    assertThat(SizeList.parse("50,10-30:10,20", 100)).containsExactly(10, 20, 30, 50);
    assertThat(SizeList.parse("3-9:5", 9)).containsExactly(3, 8);
    assertThat(SizeList.parse("2147483646-2147483647:1", Integer.MAX_VALUE)).hasSize(2);
  }

  @Test
  void what_is_no_list_is_refused() {
    requireRefused("", "is no number and no FROM-TO:STEP");
    requireRefused("5, 6", " 6 is no number and no FROM-TO:STEP");
    requireRefused("5-9", "5-9 is no number and no FROM-TO:STEP");
    requireRefused("2", "2 is not from 3 to 100");
    requireRefused("101", "101 is not from 3 to 100");
    requireRefused("5-9:0", "5-9:0 has no numbers in it");
    requireRefused("9-5:1", "9-5:1 has no numbers in it");
  }

  private static void requireRefused(String text, String sentence) {
    assertThatThrownBy(() -> SizeList.parse(text, 100))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(sentence);
  }
}
