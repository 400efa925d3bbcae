package dct.experiment.generate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.geometry.Region;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Random regions have the vertices and holes that were asked for; that they are regions is checked
 * when they are made.
 *
 * <pre>
 * Region annulus = RegionShape.ANNULUS.generate(40, 1, 7, Progress.NONE);
 * annulus.rings().size(1); // 20
 * </pre>
 */
class RegionShapeTest {

  @ParameterizedTest
  @EnumSource(RegionShape.class)
  void everyShapeHasWhatWasAskedFor(RegionShape shape) {
    for (int seed = 0; seed < 60; seed++) {
      int holes = shape == RegionShape.ANNULUS ? 1 : 1 + seed % 4;
      int n = 8 + 2 * seed + 12 * holes;
      Region region = shape.generate(n, holes, seed, Progress.NONE);
      assertThat(region.size()).isEqualTo(n);
      assertThat(region.holes()).isEqualTo(holes);
      assertThat(region.sites()).isZero();
      assertThat(shape.generate(n, holes, seed, Progress.NONE).rings()).isEqualTo(region.rings());
    }
  }

  @ParameterizedTest
  @EnumSource(RegionShape.class)
  void whatCannotBeIsRefusedWithASentence(RegionShape shape) {
    assertThatThrownBy(() -> shape.generate(5, 1, 1, Progress.NONE))
        .isInstanceOf(CannotGenerateException.class)
        .hasMessageContaining("5 vertices cannot have 1 hole;");
    assertThatThrownBy(() -> shape.generate(50, 0, 1, Progress.NONE))
        .isInstanceOf(CannotGenerateException.class);
  }

  @ParameterizedTest
  @EnumSource(RegionShape.class)
  void theSmallestAreRegions(RegionShape shape) {
    int n = shape == RegionShape.COURTYARDS ? 8 : 6;
    for (int seed = 0; seed < 200; seed++) {
      assertThat(shape.generate(n, 1, seed, Progress.NONE).size()).isEqualTo(n);
    }
  }
}
