package dct.ui.document;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.best.BestTriangulation;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import dct.ui.job.Jobs;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;

class EditorTest {
  private final Jobs jobs = new Jobs();
  private final Editor sites = new Editor(Domain.SITES, jobs);

  @Test
  void theAnalysisFollowsEveryEdit() {
    sites.perform(Edit.draw(sites.document(), 0, 0));
    sites.perform(Edit.draw(sites.document(), 9, 0));
    assertThat(sites.shown().triangulation()).isEmpty();
    sites.perform(Edit.draw(sites.document(), 4, 7));
    assertThat(sites.shown().triangulation().orElseThrow().triangleCount()).isEqualTo(1);
    sites.undo();
    assertThat(sites.shown().triangulation()).isEmpty();
  }

  @Test
  void aPreviewIsShownAndLeavesTheDocumentAlone() {
    load(0, 0, 9, 0, 4, 7);
    Document before = sites.document();
    sites.preview(before.points().moved(2, 4, 20));
    assertThat(sites.shown().document().points().y(2)).isEqualTo(20);
    assertThat(sites.document()).isEqualTo(before);
    assertThat(sites.history().isChanged()).isFalse();
    sites.endPreview();
    assertThat(sites.shown().document()).isEqualTo(before);
  }

  @Test
  void flipsOfAnOlderTriangulationAreNotShown() {
    load(0, 0, 9, 0, 4, 7, 12, 8, 3, 3, 8, 5, 2, 9);
    var result = ScanFlip.run(sites.shown().triangulation().orElseThrow());
    sites.perform(Edit.draw(sites.document(), 20, 20));
    sites.showFlips(result);
    assertThat(sites.shown().scene().counts()).hasSize(1);
    var fresh = ScanFlip.run(sites.shown().triangulation().orElseThrow());
    sites.showFlips(fresh);
    assertThat(sites.shown().scene().counts()).hasSize(2);
    assertThat(sites.shown().triangulation()).contains(fresh.after());
  }

  @Test
  void aNewWishLeavesTheTriangulationThatIsShown() {
    load(0, 0, 9, 0, 4, 7, 12, 8, 3, 3, 8, 5, 2, 9);
    var flips = ScanFlip.run(sites.shown().triangulation().orElseThrow());
    sites.showFlips(flips);
    sites.perform(Edit.wish(sites.document(), 3, Wish.ODD));
    assertThat(sites.shown().document()).isEqualTo(sites.document());
    assertThat(sites.shown().triangulation()).contains(flips.after());
    assertThat(sites.shown().scene().counts()).hasSize(1);
    sites.undo();
    assertThat(sites.shown().document().wishes().wish(3)).isEqualTo(Wish.EVEN);
    assertThat(sites.shown().triangulation()).contains(flips.after());
  }

  @Test
  void anOptimumForOtherWishesOrSitesIsNotShown() {
    load(0, 0, 9, 0, 4, 7, 12, 8, 3, 3, 8, 5, 2, 9);
    Document searched = sites.shown().document();
    Optimum best =
        BestTriangulation.of(
            sites.shown().triangulation().orElseThrow(),
            ParityGoal.allEven(7),
            SearchLimits.DEFAULT,
            Progress.NONE);
    sites.perform(Edit.wish(sites.document(), 3, Wish.ODD));
    sites.showOptimum(searched, best);
    assertThat(sites.shown().scene().counts().get(0)).doesNotContain("—");
    sites.undo();
    sites.showOptimum(searched, best);
    assertThat(sites.shown().scene().counts().get(0)).contains("—");
    assertThat(sites.shown().triangulation()).contains(best.triangulation());
  }

  @Test
  void listenersHearOfChanges() {
    AtomicInteger heard = new AtomicInteger();
    sites.addListener(heard::incrementAndGet);
    sites.perform(Edit.draw(sites.document(), 0, 0));
    assertThat(heard.get()).isEqualTo(1);
  }

  @Test
  void savingNamesTheDocument() {
    load(0, 0, 9, 0, 4, 7);
    sites.perform(Edit.draw(sites.document(), 1, 1));
    sites.saved(sites.document(), Path.of("folder", "mine_pointbased.txt"));
    assertThat(sites.name()).isEqualTo("mine_pointbased.txt");
    assertThat(sites.history().isChanged()).isFalse();
  }

  @Test
  void aLargeDocumentIsAnalysedInTheBackground() throws Exception {
    Points many = RandomSites.uniform(Editor.AT_ONCE + 1, 5);
    SwingUtilities.invokeAndWait(
        () -> {
          sites.load(new Document(Domain.SITES, many), "many");
          // The sites are there at once, their triangulation is not.
          assertThat(sites.shown().document().points()).isEqualTo(many);
          assertThat(sites.shown().triangulation()).isEmpty();
        });
    long end = System.nanoTime() + 20_000_000_000L;
    while (sites.shown().triangulation().isEmpty() && System.nanoTime() < end) {
      SwingUtilities.invokeAndWait(() -> {});
    }
    assertThat(sites.shown().triangulation()).isPresent();
  }

  private void load(double... pairs) {
    sites.load(new Document(Domain.SITES, Points.ofPairs(pairs)), "test");
  }
}
