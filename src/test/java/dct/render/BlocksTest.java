package dct.render;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Box;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class BlocksTest {

  /** Groups pass over no block of which something is in sight, and show none of the others. */
  @Test
  void theBlocksInSightAreThoseFoundOneByOne() {
    Random random = new Random(2);
    int things = 40 * 32 * Blocks.SIZE + 7; // three levels
    double[] x = random.doubles(things).sorted().toArray();
    double[] y = random.doubles(things).toArray();
    Blocks blocks = new Blocks(things);
    for (int k = 0; k < things; k++) {
      blocks.include(k, x[k], y[k]);
    }
    blocks.close();
    assertThat(blocks.count()).isEqualTo(40 * 32 + 1);
    for (double width : new double[] {0, 1e-4, 0.1, 1, 3}) {
      double left = 1.2 * random.nextDouble() - 0.2;
      Box screen = new Box(left, 0.4, left + width, 0.6);
      List<Integer> found = new ArrayList<>();
      int block = blocks.next(0, Viewport.IDENTITY, screen);
      for (; block < blocks.count(); block = blocks.next(block + 1, Viewport.IDENTITY, screen)) {
        found.add(block);
      }
      assertThat(found)
          .as("from %s, width %s", left, width)
          .isEqualTo(inSight(blocks, x, y, screen));
    }
  }

  private static List<Integer> inSight(Blocks blocks, double[] x, double[] y, Box screen) {
    List<Integer> expected = new ArrayList<>();
    for (int block = 0; block < blocks.count(); block++) {
      Box box =
          new Box(
              x[blocks.first(block)],
              y[blocks.first(block)],
              x[blocks.first(block)],
              y[blocks.first(block)]);
      for (int k = blocks.first(block); k < blocks.end(block); k++) {
        box = box.around(x[k], y[k]);
      }
      if (screen.mayMeet(box.minX(), box.minY(), box.maxX(), box.maxY())) {
        expected.add(block);
      }
    }
    return expected;
  }
}
