package dct.experiment.generate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.testing.SimplicityOracle;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class PolygonShapeTest {
  private static final int SEEDS = 3000;

  @ParameterizedTest
  @EnumSource
  void every_polygon_on_a_small_grid_is_simple_or_is_refused(PolygonShape shape) {
    int made = 0;
    for (int seed = 0; seed < SEEDS; seed++) {
      int n = 3 + seed % 14;
      Area area = new Area(1 + seed / 14 % 8, 1 + seed / 112 % 7, seed % 10 != 0);
      try {
        check(shape.generate(n, area, seed, Progress.NONE), n, area, shape + ", seed " + seed);
        made++;
      } catch (CannotGenerateException e) {
        assertThat(e.getMessage()).isNotBlank();
      }
    }
    assertThat(made).isGreaterThan(SEEDS / 10);
  }

  private static void check(SimplePolygon polygon, int n, Area area, String what) {
    Points p = polygon.points();
    assertThat(p.size()).as(what).isEqualTo(n);
    assertThat(polygon.isClockwise()).as(what).isFalse();
    assertThat(SimplicityOracle.isSimple(p)).as(what).isTrue();
    for (int i = 0; i < n; i++) {
      assertThat(p.x(i)).as(what).isGreaterThanOrEqualTo(0).isLessThan(area.width());
      assertThat(p.y(i)).as(what).isGreaterThanOrEqualTo(0).isLessThan(area.height());
      boolean whole = p.x(i) == Math.rint(p.x(i)) && p.y(i) == Math.rint(p.y(i));
      assertThat(whole || !area.whole()).as(what).isTrue();
    }
  }

  @Test
  void a_cancelled_polygon_is_not_made() {
    Progress cancelled =
        new Progress() {
          @Override
          public void report(double fraction, String message) {}

          @Override
          public boolean isCancelled() {
            return true;
          }
        };
    assertThatThrownBy(() -> PolygonShape.TWO_OPT.generate(9, Area.CANVAS, 1, cancelled))
        .isInstanceOf(CancellationException.class);
  }
}
