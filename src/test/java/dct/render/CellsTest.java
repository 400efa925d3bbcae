package dct.render;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Box;
import java.util.Random;
import org.junit.jupiter.api.Test;

class CellsTest {
  private static final Box SCREEN = new Box(0, 0, 1000, 700);
  private final Cells cells = new Cells(SCREEN, Viewport.IDENTITY);

  @Test
  void aBoxIsFreeUntilACellThatItMeetsIsTaken() {
    assertThat(cells.isFree(100, 100, 130, 110)).isTrue();
    cells.take(125, 105, 140, 140);
    assertThat(cells.isFree(100, 100, 130, 110)).isFalse();
    assertThat(cells.isFree(100, 100, 120, 110)).isTrue();
    assertThat(cells.isFree(0, 0, 1000, 99)).isTrue();
  }

  /** 35 cells below each other, each in a row of its own, over the borders of words. */
  @Test
  void cellsAreCountedAcrossWords() {
    for (int row = 0; row < 35; row++) {
      cells.take(28 * row + 1, 4 * row + 1, 28 * row + 2, 4 * row + 2);
    }
    assertThat(cells.count(0, 0, 1000, 700)).isEqualTo(35);
    assertThat(cells.count(28 * 9, 0, 28 * 20 + 3, 700)).isEqualTo(12);
  }

  @Test
  void aLineTakesTheCellsUnderIt() {
    for (long seed = 0; seed < 100; seed++) {
      Random random = new Random(seed);
      Cells fresh = new Cells(SCREEN, Viewport.IDENTITY);
      double[] ends = random.doubles(4, 10, 690).toArray();
      fresh.takeLine(ends[0], ends[1], ends[2], ends[3]);
      for (double part = 0; part <= 1; part += 1.0 / 64) {
        double x = ends[0] + part * (ends[2] - ends[0]);
        double y = ends[1] + part * (ends[3] - ends[1]);
        assertThat(fresh.isFree(x - 4, y - 4, x + 4, y + 4)).as("seed %d", seed).isFalse();
      }
      assertThat(fresh.count(0, 0, 1000, 700)).isLessThanOrEqualTo(350);
    }
  }

  @Test
  void ofALineOutsideOnlyThePartInSightIsTaken() {
    cells.takeLine(-1e12, 350, 1e12, 350);
    assertThat(cells.count(0, 0, 1000, 700)).isBetween(250, 252);
    cells.takeLine(-1e12, -5e11, -10, 1e11);
    cells.takeLine(1e300, 1e300, -1e300, 1e299);
    cells.takeLine(Double.NaN, 3, 4, 5);
    assertThat(cells.count(0, 0, 1000, 340)).isZero();
    assertThat(cells.count(0, 360, 1000, 700)).isZero();
  }

  @Test
  void whenThePictureIsPannedTheCellsGoWithIt() {
    for (double by : new double[] {0.5, 1, 2.75, 3.99, 4, -1.3}) {
      Cells panned = new Cells(SCREEN, Viewport.IDENTITY.panned(by, by));
      panned.take(400 + by, 300 + by, 401 + by, 301 + by);
      assertThat(panned.isFree(396 + by, 300 + by, 399.9 + by, 303 + by)).as("by %s", by).isTrue();
      assertThat(panned.isFree(403.9 + by, 300 + by, 405 + by, 303 + by)).as("by %s", by).isFalse();
    }
  }
}
