package dct.core;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class SeededRandomTest {

  @Test
  void is_splitmix64() {
    SeededRandom random = new SeededRandom(1234567);
    assertThat(random.nextLong()).isEqualTo(6457827717110365317L);
    assertThat(random.nextLong()).isEqualTo(3203168211198807973L);
    SplittableRandom reference = new SplittableRandom(-99);
    SeededRandom same = new SeededRandom(-99);
    for (int i = 0; i < 1000; i++) {
      assertThat(same.nextLong()).isEqualTo(reference.nextLong());
    }
  }

  @Test
  void bounded_integers_are_even_handed() {
    SeededRandom random = new SeededRandom(3);
    int[] count = new int[6];
    for (int i = 0; i < 60_000; i++) {
      count[random.nextInt(6)]++;
    }
    assertThat(Arrays.stream(count)).allMatch(c -> c > 9_600 && c < 10_400);
  }

  @Test
  void doubles_lie_from_zero_to_one() {
    SeededRandom random = new SeededRandom(5);
    double sum = 0;
    for (int i = 0; i < 10_000; i++) {
      double value = random.nextDouble();
      assertThat(value).isBetween(0.0, Math.nextDown(1.0));
      sum += value;
    }
    assertThat(sum / 10_000).isBetween(0.49, 0.51);
  }

  @Test
  void refuses_an_empty_range() {
    assertThatThrownBy(() -> new SeededRandom(1).nextInt(0))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void streams_of_parts_differ_and_repeat() {
    long first = SeededRandom.of(1, 0, 0).nextLong();
    assertThat(SeededRandom.of(1, 0, 0).nextLong()).isEqualTo(first);
    assertThat(SeededRandom.of(1, 0, 1).nextLong()).isNotEqualTo(first);
    assertThat(SeededRandom.of(1, 1, 0).nextLong()).isNotEqualTo(first);
    assertThat(SeededRandom.of(2, 0, 0).nextLong()).isNotEqualTo(first);
  }

  @Test
  void thirty_two_bits_are_the_upper_half() {
    assertThat(new SeededRandom(9).nextInt())
        .isEqualTo((int) (new SeededRandom(9).nextLong() >>> 32));
  }
}
