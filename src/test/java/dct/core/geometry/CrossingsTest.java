package dct.ui.document;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Defect;
import dct.core.geometry.Points;
import dct.core.geometry.SimplicityCheck;
import java.util.Random;
import org.junit.jupiter.api.Test;

class CrossingsTest {

  @Test
  void allCrossingsAreFoundNotOnlyTheFirst() {
    // A line through three teeth.
    Points points =
        Points.ofPairs(0, 5, 70, 5, 70, 20, 60, 0, 50, 20, 40, 0, 30, 20, 20, 0, 10, 20);
    assertThat(Crossings.of(points))
        .hasSize(6)
        .allSatisfy(crossing -> assertThat(crossing.first()).isZero())
        .allSatisfy(crossing -> assertThat(crossing.y()).isEqualTo(5));
  }

  @Test
  void theCrossingOfABowTieIsInItsMiddle() {
    assertThat(Crossings.of(Points.ofPairs(0, 0, 10, 10, 10, 0, 0, 10)))
        .containsExactly(new Defect(Defect.Kind.CROSSING, 0, 2, 5, 5, 4));
  }

  @Test
  void aPolygonIsFoundToCrossIfTheCheckSaysSo() {
    for (long seed = 0; seed < 300; seed++) {
      Random random = new Random(seed);
      double[] pairs = random.doubles(2L * (3 + random.nextInt(6)), 0, 100).toArray();
      Points points = Points.ofPairs(pairs);
      assertThat(Crossings.of(points).isEmpty())
          .as("seed %d", seed)
          .isEqualTo(SimplicityCheck.firstDefect(points, Progress.NONE).isEmpty());
    }
  }
}
