package dct.experiment.study;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RunClockTest {

  @Test
  void the_time_left_follows_from_the_time_gone() {
    assertThat(RunClock.words(0, 9)).isEqualTo("0 %");
    assertThat(RunClock.words(0.25, 30)).isEqualTo("25 %, about 1:30 left");
    assertThat(RunClock.words(1, 30)).isEqualTo("100 %, about 0:00 left");
  }
}
