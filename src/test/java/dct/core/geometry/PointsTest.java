package dct.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

class PointsTest {
  private static final Points FOUR = Points.ofPairs(0, 0, 4, 0, 4, 3, 0, 3);

  @Test
  void oneMovedPointIsTheOnlyDifference() {
    for (int i = 0; i < FOUR.size(); i++) {
      assertThat(FOUR.onlyDifference(FOUR.moved(i, 9, 8))).isEqualTo(i);
      assertThat(FOUR.onlyDifference(FOUR.moved(i, FOUR.x(i), 8))).isEqualTo(i);
      assertThat(FOUR.onlyDifference(FOUR.moved(i, 9, FOUR.y(i)))).isEqualTo(i);
    }
  }

  @Test
  void otherwiseThereIsNoOnlyDifference() {
    assertThat(FOUR.onlyDifference(FOUR)).isEqualTo(Points.NONE);
    assertThat(FOUR.onlyDifference(FOUR.moved(0, 9, 0).moved(3, 0, 9))).isEqualTo(Points.NONE);
    assertThat(FOUR.onlyDifference(FOUR.moved(1, 4, 9).moved(2, 9, 3))).isEqualTo(Points.NONE);
    assertThat(FOUR.onlyDifference(FOUR.removed(3))).isEqualTo(Points.NONE);
  }

  @Test
  void aMoveLeavesThePointsAloneAndStoresNegativeZeroAsZero() {
    Points moved = FOUR.moved(2, -0.0, 7);
    assertThat(FOUR.x(2)).isEqualTo(4);
    assertThat(moved).isEqualTo(Points.ofPairs(0, 0, 4, 0, 0, 7, 0, 3));
    assertThatIllegalArgumentException().isThrownBy(() -> FOUR.moved(1, Double.NaN, 0));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> FOUR.moved(1, 0, Double.POSITIVE_INFINITY));
  }

  @Test
  void theBoxOfTheOthers() {
    assertThat(Box.ofOthers(FOUR.moved(1, 9, -2), 1)).isEqualTo(new Box(0, 0, 4, 3));
    assertThat(Box.ofOthers(Points.ofPairs(5, 5, 1, 2), 0)).isEqualTo(new Box(1, 2, 1, 2));
    assertThat(Box.of(FOUR).around(5, -1)).isEqualTo(new Box(0, -1, 5, 3));
    assertThatIllegalArgumentException().isThrownBy(() -> Box.ofOthers(Points.ofPairs(1, 1), 0));
  }
}
