package dct.ui.random;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.experiment.generate.Area;
import dct.experiment.generate.RandomSites;
import dct.ui.dialog.Form;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import javax.swing.JCheckBox;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;

class RandomPlanTest {
  private static RandomPlan plan(Domain domain, int shape, Optional<Area> area, boolean real) {
    return new RandomPlan(domain, 40, RandomPlan.shapes(domain).get(shape), 7, area, real, 1);
  }

  @Test
  void theUsualSitesAreUniform() {
    RandomPlan plan = plan(Domain.SITES, 0, Optional.empty(), false);
    assertThat(plan.generate(Progress.NONE).points()).isEqualTo(RandomSites.uniform(40, 7));
    assertThat(plan.words()).isEqualTo("Uniform, 40 sites, seed 7");
    assertThat(plan.call().line()).isEqualTo("dct generate points -n 40 --shape uniform --seed 7");
  }

  @Test
  void anAreaAndRealCoordinatesAreKept() {
    RandomPlan plan = plan(Domain.POLYGON, 0, Optional.of(new Area(30, 20, true)), true);
    var points = plan.generate(Progress.NONE).points();
    assertThat(points.size()).isEqualTo(40);
    for (int v = 0; v < 40; v++) {
      assertThat(points.x(v)).isBetween(0.0, 30.0);
      assertThat(points.y(v)).isBetween(0.0, 20.0);
    }
    assertThat(Arrays.stream(points.xs()).anyMatch(x -> x != Math.rint(x))).isTrue();
    assertThat(plan.call().line()).endsWith("--seed 7 --area 30x20 --real");
  }

  @Test
  void everyShapeIsMadeAsTheCommandLineMakesIt() {
    for (Domain domain : Domain.values()) {
      for (int shape = 0; shape < RandomPlan.shapes(domain).size(); shape++) {
        RandomPlan plan = plan(domain, shape, Optional.empty(), false);
        assertThat(plan.generate(Progress.NONE).size()).as(plan.words()).isEqualTo(40);
      }
    }
  }

  @Test
  void aRegionHasItsHoles() {
    RandomPlan.Shape shape = RandomPlan.shapes(Domain.REGION).get(1);
    RandomPlan plan = new RandomPlan(Domain.REGION, 60, shape, 3, Optional.empty(), false, 2);
    assertThat(plan.generate(Progress.NONE).layout().holes()).isEqualTo(2);
    assertThat(plan.words()).isEqualTo("With holes, 60 vertices, 2 holes, seed 3");
    assertThat(plan.call().line())
        .isEqualTo("dct generate region -n 60 --shape holes --seed 3 --holes 2");
  }

  @Test
  void aFormSaysWhatCannotBe() {
    List<RandomForm> copied = new ArrayList<>();
    RandomForm form = new RandomForm(Domain.SITES, copied::add);
    assertThat(form.plan().call().line())
        .isEqualTo("dct generate points -n 100 --shape uniform --seed 1");
    form.suggestAfter(8);
    ((JCheckBox) named(form, "real")).setSelected(true);
    type(form, "area", " 500 × 300 ");
    assertThat(form.plan().call().line()).endsWith("--seed 9 --area 500x300 --real");
    type(form, "area", "0x300");
    assertThatThrownBy(form::plan).hasMessageContaining("an area of 0 × 300 cannot be");
    type(form, "area", "wide");
    assertThatThrownBy(form::plan).hasMessageContaining("“wide” is no area; type a width and");
    type(form, "seed", "x");
    assertThatThrownBy(form::plan).hasMessageContaining("“x” is no seed; type a whole number");
    type(form, "vertices", "0");
    assertThatThrownBy(form::plan).hasMessageContaining("“0” is no number of sites");
    ((javax.swing.AbstractButton) named(form, "copyCall")).doClick();
    assertThat(copied).containsExactly(form);
  }

  private static void type(Form form, String field, String text) {
    ((JTextField) named(form, field)).setText(text);
  }

  private static java.awt.Component named(Form form, String name) {
    for (java.awt.Component each : form.getComponents()) {
      if (name.equals(each.getName())) {
        return each;
      }
    }
    throw new AssertionError(name);
  }
}
