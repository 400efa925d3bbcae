package dct.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.testing.CancelledAfter;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;

/**
 * {@link HilbertOrder}: an example.
 *
 * <pre>{@code
 * int[] order = HilbertOrder.of(Points.ofPairs(0, 0, 1, 0, 0, 1, 1, 1), Progress.NONE);
 * order[0]; // the first point along the curve, a corner of the box
 * }</pre>
 */
class HilbertOrderTest {

  @Test
  void neighboursAlongTheCurveAreNeighboursOfALattice() {
    double[] pairs = new double[512];
    for (int i = 0; i < 256; i++) {
      int row = i / 16;
      pairs[2 * i] = i % 16;
      pairs[2 * i + 1] = row;
    }
    int[] order = HilbertOrder.of(Points.ofPairs(pairs), Progress.NONE);
    assertThat(order).hasSize(256).doesNotHaveDuplicates();
    for (int k = 1; k < order.length; k++) {
      int columns = Math.abs(order[k] % 16 - order[k - 1] % 16);
      int rows = Math.abs(order[k] / 16 - order[k - 1] / 16);
      assertThat(columns + rows).as("step %d", k).isEqualTo(1);
    }
  }

  @Test
  void canBeCancelled() {
    assertThatThrownBy(() -> HilbertOrder.of(Points.ofPairs(0, 0, 1, 1), new CancelledAfter(0)))
        .isInstanceOf(CancellationException.class);
  }
}
