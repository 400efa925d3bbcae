package dct.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.geometry.Box;
import dct.core.geometry.Points;
import java.awt.geom.Path2D;
import java.util.Random;
import org.junit.jupiter.api.Test;

class CornersTest {
  private static final Box PART = new Box(20, 10, 80, 60);

  @Test
  void whatLiesInThePartStaysAsItIs() {
    Corners corners = Corners.of(Points.ofPairs(30, 20, 70, 20, 50, 50), Viewport.IDENTITY, PART);
    assertThat(corners.xs()).containsExactly(30, 70, 50);
    assertThat(corners.ys()).containsExactly(20, 20, 50);
  }

  @Test
  void ofAPolygonElsewhereNothingIsLeft() {
    Points far = Points.ofPairs(130, 20, 170, 20, 150, 50);
    assertThat(Corners.of(far, Viewport.IDENTITY, PART).isEmpty()).isTrue();
  }

  /** Random ones cross themselves all over. */
  @Test
  void withinThePartTheSamePlacesAreCovered() {
    for (long seed = 0; seed < 200; seed++) {
      Random random = new Random(seed);
      Points points =
          Points.ofPairs(random.doubles(2L * (3 + random.nextInt(9)), 0, 100).toArray());
      Corners corners = Corners.of(points, Viewport.IDENTITY, PART);
      Path2D whole = path(points.xs(), points.ys());
      Path2D cut = path(corners.xs(), corners.ys());
      for (int i = 0; i < 200; i++) {
        double x = 20.01 + 59.9 * random.nextDouble();
        double y = 10.01 + 49.9 * random.nextDouble();
        assertThat(cut.contains(x, y))
            .as("seed %d, (%s, %s)", seed, x, y)
            .isEqualTo(whole.contains(x, y));
      }
      for (int i = 0; i < corners.xs().length; i++) {
        assertThat(corners.xs()[i]).isBetween(20.0, 80.0);
        assertThat(corners.ys()[i]).isCloseTo(35, within(25.0));
      }
    }
  }

  private static Path2D path(double[] x, double[] y) {
    Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
    for (int i = 0; i < x.length; i++) {
      if (i == 0) {
        path.moveTo(x[i], y[i]);
      } else {
        path.lineTo(x[i], y[i]);
      }
    }
    if (x.length > 0) {
      path.closePath();
    }
    return path;
  }

  @Test
  void placesThatNumbersCannotHoldLeaveNothing() {
    Points huge = Points.ofPairs(0, 0, 1e300, 0, 0, 1e300);
    Viewport view = Viewport.IDENTITY.zoomed(1e100, 50, 40);
    assertThat(Corners.of(huge, view, PART).isEmpty()).isTrue();
  }
}
