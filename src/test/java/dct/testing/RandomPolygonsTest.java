package dct.testing;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.testing.RandomPolygons.Family;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The figures that the other tests stand on are what they say. */
class RandomPolygonsTest {

  static List<Family> families() {
    return RandomPolygons.families();
  }

  @ParameterizedTest
  @MethodSource("families")
  void everyPolygonIsSimpleAndRepeatable(Family family) {
    for (int seed = 0; seed < 60; seed++) {
      int n = 3 + seed;
      Points p = family.make(n, seed);
      assertThat(SimplicityOracle.isSimple(p)).as("%s, n %d, seed %d", family, n, seed).isTrue();
      assertThat(family.make(n, seed)).isEqualTo(p);
    }
  }

  @Test
  void oracleRefusesWhatIsNotSimple() {
    assertThat(SimplicityOracle.isSimple(Points.ofPairs(0, 0, 1, 1))).isFalse();
    assertThat(SimplicityOracle.isSimple(Points.ofPairs(0, 0, 2, 2, 2, 0, 0, 2))).isFalse();
    assertThat(SimplicityOracle.isSimple(Points.ofPairs(0, 0, 4, 0, 2, 0))).isFalse();
    assertThat(SimplicityOracle.isSimple(Points.ofPairs(0, 0, 4, 0, 4, 4, 2, 0))).isFalse();
    assertThat(SimplicityOracle.isSimple(Points.ofPairs(0, 0, 4, 0, 4, 4, 4, 4, 0, 4))).isFalse();
    assertThat(SimplicityOracle.isSimple(Points.ofPairs(0, 0, 4, 0, 2, 0, 2, 4))).isFalse();
  }

  @Test
  void oracleAcceptsStraightVertices() {
    assertThat(SimplicityOracle.isSimple(Points.ofPairs(0, 0, 2, 0, 4, 0, 2, 3))).isTrue();
  }
}
