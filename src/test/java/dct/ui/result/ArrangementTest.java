package dct.ui.result;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Box;
import java.awt.Dimension;
import org.junit.jupiter.api.Test;

/** Where views go by the room that there is. */
class ArrangementTest {
  private static final Dimension CANVAS = new Dimension(1000, 700);

  @Test
  void byRoomViewsAreWhereTheDrawingIsLarger() {
    assertThat(Arrangement.AUTO.isBelow(new Box(0, 0, 900, 200), CANVAS)).isTrue();
    assertThat(Arrangement.AUTO.isBelow(new Box(0, 0, 300, 600), CANVAS)).isFalse();
    assertThat(Arrangement.TABS.isBelow(new Box(0, 0, 900, 200), CANVAS)).isTrue();
    assertThat(Arrangement.AUTO.isBelow(new Box(0, 0, 900, 0), CANVAS)).isTrue();
    assertThat(Arrangement.AUTO.isBelow(new Box(0, 0, 0, 900), CANVAS)).isFalse();
  }

  @Test
  void whatIsChosenIsDone() {
    assertThat(Arrangement.SIDE_BY_SIDE.isBelow(new Box(0, 0, 900, 200), CANVAS)).isFalse();
    assertThat(Arrangement.STACKED.isBelow(new Box(0, 0, 300, 600), CANVAS)).isTrue();
    assertThat(Arrangement.STACKED.isTabbed(5)).isFalse();
    assertThat(Arrangement.TABS.isTabbed(1)).isTrue();
    assertThat(Arrangement.AUTO.isTabbed(2)).isFalse();
    assertThat(Arrangement.AUTO.isTabbed(3)).isTrue();
  }

  @Test
  void itsWordIsReadBack() {
    for (Arrangement arrangement : Arrangement.values()) {
      assertThat(Arrangement.of(arrangement.word())).isEqualTo(arrangement);
    }
    assertThat(Arrangement.of("no such word")).isEqualTo(Arrangement.AUTO);
  }
}
