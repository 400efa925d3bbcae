package dct.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dct.core.Progress;
import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import dct.io.FileEnding;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FigureTest {
  private static final double POINTS = 72 / 25.4; // of each millimetre

  private static Scene scene(Points sites) {
    Instance instance = Instance.of(Domain.SITES, "sites", sites, Progress.NONE);
    return Scene.of(Solution.of(instance, Method.byDefault(Domain.SITES), Progress.NONE));
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 10, 60, 400})
  void counts_and_legend_cover_no_vertex(int n) {
    for (int seed = 0; seed < 20; seed++) {
      Scene scene = scene(RandomSites.uniform(n, seed));
      for (boolean up : new boolean[] {false, true}) {
        Sheet sheet = SheetLayout.of(scene, Figure.DEFAULT.withLegend(true).withYUp(up));
        List<Box> notes =
            List.of(sheet.counts().orElseThrow().box(), sheet.legend().orElseThrow().box());
        assertThat(notes.get(0).grown(-1).meets(notes.get(1).grown(-1))).isFalse();
        for (int v = 0; v < n; v++) {
          double x = sheet.view().screenX(scene.x(v));
          double y = sheet.view().screenY(scene.y(v));
          assertThat(sheet.box().holds(x, y)).as("v%d of seed %d", v, seed).isTrue();
          assertThat(notes).as("v%d, seed %d", v, seed).noneMatch(box -> box.holds(x, y));
        }
      }
    }
  }

  @Test
  void a_column_has_fine_lines_and_letters_for_print() {
    Scene scene = scene(RandomSites.uniform(20, 1));
    Sheet sheet = SheetLayout.of(scene, Figure.DEFAULT);
    assertThat(sheet.pointsWide()).isCloseTo(84 * POINTS, within(1e-9));
    assertThat(sheet.points() * 11).isBetween(7.0, 9.0); // labels
    assertThat(sheet.points() * 14).isBetween(7.0, 9.0); // counts
    Stroke diagonal = sheet.gauge().of(Stroke.solid(Ink.DIAGONAL, 1.2));
    assertThat(sheet.points() * diagonal.width()).isCloseTo(0.4, within(0.01));
    Stroke faint = sheet.gauge().of(Stroke.solid(Ink.PROPOSED, 0.5));
    assertThat(sheet.points() * faint.width()).isCloseTo(0.25, within(1e-9));
  }

  @Test
  void a_tall_drawing_is_narrower_and_a_flat_one_low() {
    Figure plain = Figure.DEFAULT;
    Sheet tall = SheetLayout.of(Scene.sites(Points.ofPairs(0, 0, 1, 1000)), plain);
    assertThat(tall.height()).isLessThanOrEqualTo(2.5 * 84 * POINTS / tall.points() + 1e-9);
    assertThat(tall.width()).isLessThan(tall.height() / 10);
    Sheet flat = SheetLayout.of(Scene.sites(Points.ofPairs(0, 0, 1000, 0)), plain);
    assertThat(flat.height()).isBetween(5.0, 30.0);
    Sheet none = SheetLayout.of(Scene.sites(Points.ofPairs()), plain);
    assertThat(none.height()).isPositive();
  }

  @Test
  void sizes_out_of_range_are_refused() {
    assertThatThrownBy(() -> new Figure.Size(Double.NaN, Figure.Unit.MM))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new Figure.Size(3, Figure.Unit.PX))
        .hasMessage("3px is out of range; take from 50px to 4000px");
    assertThat(Figure.Size.parse("84 mm")).isEqualTo(Figure.Size.COLUMN);
    assertThatThrownBy(() -> Figure.Size.parse("84"))
        .hasMessage("84 is no width; write 84mm or 600px");
  }

  @Test
  void tex_is_warned_of_above_so_many_edges() {
    Scene many = scene(RandomSites.uniform(1100, 1));
    assertThat(PictureFile.warning(many, FileEnding.TEX).orElseThrow()).contains("edges");
    assertThat(PictureFile.warning(many, FileEnding.PDF)).isEmpty();
    Scene few = scene(RandomSites.uniform(900, 1));
    assertThat(PictureFile.warning(few, FileEnding.TEX)).isEmpty();
  }
}
