package dct.ui.canvas;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import org.junit.jupiter.api.Test;

class ClicksTest {
  private final Clicks clicks = new Clicks(500);

  @Test
  void aTremblingHandStillMakesADoubleClick() {
    assertThat(clicks.count(1000, new Point(50, 50))).isEqualTo(1);
    assertThat(clicks.count(1200, new Point(52, 47))).isEqualTo(2);
    assertThat(clicks.count(1700, new Point(52, 47))).isEqualTo(3);
  }

  @Test
  void aClickFartherOffIsAnother() {
    clicks.count(1000, new Point(50, 50));
    assertThat(clicks.count(1200, new Point(55, 50))).isEqualTo(1);
  }

  @Test
  void aLaterClickIsAnother() {
    clicks.count(1000, new Point(50, 50));
    assertThat(clicks.count(1501, new Point(50, 50))).isEqualTo(1);
  }
}
