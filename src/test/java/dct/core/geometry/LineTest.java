package dct.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.SegmentPoints.Place;
import org.junit.jupiter.api.Test;

class LineTest {

  @Test
  void coordinatesAreTheNearestDoubles() {
    Line diagonal = Line.through(0, 0, 3, 1);
    assertThat(diagonal.crossing(Line.along(1, 0, 0, 5))).contains(new Place(1, 1.0 / 3));
    assertThat(diagonal.crossing(Line.through(0, 1, 1, 0))).contains(new Place(0.75, 0.25));
  }

  @Test
  void aLevelLineIsMetExactlyInAnyScale() {
    for (double y : new double[] {0.1, 1e-300, 1e300, -7.3}) {
      Line level = Line.along(0.3, y, 1, 0);
      Place place = Line.through(0, 0, 1, y < 0 ? -3 : 3).crossing(level).orElseThrow();
      assertThat(place.y()).isEqualTo(y);
    }
  }

  @Test
  void parallelLinesAndThoseThatMeetBeyondDoublesHaveNone() {
    assertThat(Line.through(0.1, 0.1, 0.3, 0.3).crossing(Line.along(5, 0, 2, 2))).isEmpty();
    Line flat = Line.along(0, Double.MAX_VALUE, 1, Double.MIN_VALUE);
    assertThat(flat.crossing(Line.along(0, 0, 1, 0))).isEmpty();
  }
}
