package dct.ui.document;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.RandomSites;
import dct.problem.Solution;
import dct.render.Scene;
import dct.ui.job.Jobs;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;

class EditorTest {
  private final Jobs jobs = new Jobs();
  private final Editor sites = new Editor(Domain.SITES, jobs);

  @Test
  void theAnalysisFollowsEveryEdit() {
    sites.perform(Edit.draw(sites.document(), 0, 0));
    sites.perform(Edit.draw(sites.document(), 9, 0));
    assertThat(sites.shown().solution()).isEmpty();
    sites.perform(Edit.draw(sites.document(), 4, 7));
    assertThat(sites.shown().solution().orElseThrow().triangulation().triangleCount()).isEqualTo(1);
    sites.undo();
    assertThat(sites.shown().solution()).isEmpty();
  }

  @Test
  void sitesOnOneLineAreShownAsAPathAndHaveNoSolution() {
    load(0, 0, 9, 0, 4, 0);
    assertThat(sites.shown().solution()).isEmpty();
    assertThat(sites.shown().scene().edgeCount()).isEqualTo(2);
    assertThat(sites.shown().defects()).hasSize(1);
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
  void whileAPolygonIsDrawnItsLastEdgeIsNoFault() {
    Editor polygon = new Editor(Domain.POLYGON, jobs);
    polygon.setGrowing(true);
    double[] crossedByTheLastEdge = {100, 100, 500, 100, 500, 400, 700, 250};
    for (int v = 0; v < 4; v++) {
      polygon.perform(
          Edit.draw(
              polygon.document(), crossedByTheLastEdge[2 * v], crossedByTheLastEdge[2 * v + 1]));
      assertThat(polygon.shown().defects()).as("v%d", v).isEmpty();
    }
    polygon.setGrowing(false);
    assertThat(polygon.shown().defects()).isNotEmpty();
    polygon.setGrowing(true);
    polygon.perform(Edit.draw(polygon.document(), 300, 50)); // crosses v0–v1
    assertThat(polygon.shown().defects())
        .extracting(defect -> defect.first() + " " + defect.second())
        .contains("0 3")
        .noneMatch(edges -> edges.contains("4"));
  }

  private static final double[] SEVEN = {0, 0, 9, 0, 4, 7, 12, 8, 3, 3, 8, 5, 2, 9};

  @Test
  void flipsAreAStepOfTheHistory() {
    load(SEVEN);
    Document before = sites.document();
    Result flips = flipped();
    assertThat(sites.accept("Perform Flip", before, flips)).isTrue();
    assertThat(sites.history().undoLabel()).contains("Perform Flip");
    assertThat(sites.shown().solution()).contains(flips.solution());
    assertThat(sites.shown().scene().counts()).hasSize(2);
    sites.undo();
    assertThat(sites.document()).isEqualTo(before);
    assertThat(sites.shown().scene().counts()).hasSize(1);
    sites.redo();
    assertThat(sites.shown().solution()).contains(flips.solution());
  }

  @Test
  void flipsOfOlderSitesAreNotTakenOver() {
    load(SEVEN);
    Document older = sites.document();
    Result flips = flipped();
    sites.perform(Edit.draw(sites.document(), 20, 20));
    assertThat(sites.accept("Perform Flip", older, flips)).isFalse();
    assertThat(sites.shown().scene().counts()).hasSize(1);
    assertThat(sites.history().undoLabel()).contains("Draw Vertex v7");
  }

  @Test
  void anEditDropsTheResultAndUndoBringsItBack() {
    load(SEVEN);
    Result flips = flipped();
    sites.accept("Perform Flip", sites.document(), flips);
    sites.perform(Edit.move(sites.document(), 3, 12, 9));
    assertThat(sites.document().result()).isEmpty();
    assertThat(sites.shown().scene().counts()).hasSize(1);
    sites.undo();
    assertThat(sites.shown().solution()).contains(flips.solution());
    assertThat(sites.shown().scene().counts()).hasSize(2);
    sites.perform(Edit.result("Delaunay", sites.document(), Optional.empty()));
    assertThat(sites.shown().scene().counts()).hasSize(1);
    sites.undo();
    assertThat(sites.shown().solution()).contains(flips.solution());
  }

  private Result flipped() {
    return Result.of(
        Result.CANVAS,
        "Perform Flip",
        sites.shown().solution().orElseThrow().flipped(Progress.NONE));
  }

  @Test
  void aNewWishLeavesTheTriangulationThatIsShown() {
    load(SEVEN);
    Result flips = flipped();
    sites.accept("Perform Flip", sites.document(), flips);
    sites.perform(Edit.wish(sites.document(), 3, Wish.ODD));
    assertThat(sites.shown().document()).isEqualTo(sites.document());
    assertThat(triangulation()).isSameAs(flips.solution().triangulation());
    assertThat(sites.shown().scene().counts()).hasSize(1);
    sites.undo();
    assertThat(sites.shown().document().wishes().wish(3)).isEqualTo(Wish.EVEN);
    assertThat(sites.shown().solution()).contains(flips.solution());
  }

  private Triangulation triangulation() {
    return sites.shown().solution().orElseThrow().triangulation();
  }

  @Test
  void anOptimumForOtherWishesIsNotTakenOver() {
    load(SEVEN);
    Document searched = sites.document();
    Solution best =
        sites.shown().solution().orElseThrow().optimized(SearchLimits.DEFAULT, Progress.NONE);
    Result result = Result.of(Result.CANVAS, "Most Even Vertices", best);
    sites.perform(Edit.wish(sites.document(), 3, Wish.ODD));
    assertThat(sites.accept("Most Even Vertices", searched, result)).isFalse();
    assertThat(sites.shown().scene().counts().get(0)).doesNotContain("—");
    sites.undo();
    assertThat(sites.accept("Most Even Vertices", searched, result)).isTrue();
    assertThat(sites.shown().scene().counts().get(0)).contains("—");
    assertThat(sites.shown().solution()).contains(best);
    assertThat(sites.history().hasUnsavedResult()).isTrue();
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
    sites.saved(
        sites.document(), new Origin(Path.of("folder", "mine_pointbased.txt"), Optional.empty()));
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
          assertThat(sites.shown().solution()).isEmpty();
        });
    long end = System.nanoTime() + 20_000_000_000L;
    while (sites.shown().solution().isEmpty() && System.nanoTime() < end) {
      SwingUtilities.invokeAndWait(() -> {});
    }
    assertThat(sites.shown().solution()).isPresent();
  }

  @Test
  void theNewestOfManyPreviewsIsShownAndNoneAfterAnEdit() throws Exception {
    Points many = RandomSites.uniform(Editor.AT_ONCE + 1, 5);
    SwingUtilities.invokeAndWait(() -> sites.load(new Document(Domain.SITES, many), "many"));
    awaitShown(many);
    SwingUtilities.invokeAndWait(
        () -> {
          for (int i = 1; i <= 50; i++) {
            sites.preview(many.moved(0, -i, 0).moved(1, -i, 9));
          }
        });
    awaitShown(many.moved(0, -50, 0).moved(1, -50, 9));
    SwingUtilities.invokeAndWait(
        () -> {
          sites.preview(many.moved(0, -60, 0).moved(1, -60, 9));
          sites.perform(Edit.move(sites.document(), 0, -70, 0));
        });
    awaitShown(many.moved(0, -70, 0));
    assertThat(jobs.isIdle()).as("nothing older comes after").isTrue();
  }

  private static final Points MANY =
      Points.of(
          new Random(7).doubles(Editor.AT_ONCE + 500).toArray(),
          new Random(8).doubles(Editor.AT_ONCE + 500).toArray());

  private void loadMany() throws Exception {
    SwingUtilities.invokeAndWait(() -> sites.load(new Document(Domain.SITES, MANY), "many"));
    awaitShown(MANY);
  }

  @Test
  void whereOneOfManySitesMovesThePictureFollowsAtOnce() throws Exception {
    loadMany();
    SwingUtilities.invokeAndWait(
        () -> {
          for (int i = 0; i < 30; i++) {
            Points moved = MANY.moved(40, i / 20.0, 0.4);
            sites.preview(moved);
            assertPictureOf(moved);
            assertThat(jobs.isIdle()).as("nothing is computed in the background").isTrue();
          }
          sites.endPreview();
          assertPictureOf(MANY);
          assertThat(sites.shown().solution()).as("still known").isPresent();
          assertThat(jobs.isIdle()).isTrue();
        });
  }

  @Test
  void aDropIsShownAtOnceAndAnalysedInTheBackground() throws Exception {
    loadMany();
    Points moved = MANY.moved(40, 0.5, 0.6);
    SwingUtilities.invokeAndWait(
        () -> {
          sites.preview(moved);
          sites.perform(Edit.move(sites.document(), 40, 0.5, 0.6));
          assertPictureOf(moved);
          assertThat(sites.shown().isWhole()).isFalse();
        });
    awaitShown(moved);
    assertThat(sites.shown().isWhole()).isTrue();
    SwingUtilities.invokeAndWait(
        () -> {
          sites.undo();
          assertPictureOf(MANY);
        });
    awaitShown(MANY);
    SwingUtilities.invokeAndWait(
        () -> {
          sites.redo();
          assertPictureOf(moved);
          sites.undo();
          assertPictureOf(MANY);
          assertThat(sites.shown().isWhole()).as("known from before").isTrue();
        });
    awaitShown(MANY);
  }

  @Test
  void aMoveOfManySitesLeavesTheirFlipsOut() throws Exception {
    loadMany();
    SwingUtilities.invokeAndWait(
        () -> {
          sites.accept("Perform Flip", sites.document(), flipped());
          Points moved = MANY.moved(40, 0.5, 0.6);
          sites.preview(moved);
          assertPictureOf(moved);
          sites.endPreview();
          assertThat(sites.shown().scene().counts()).as("before and after").hasSize(2);
          assertThat(jobs.isIdle()).isTrue();
        });
  }

  @Test
  void wishesStayBesideAMovedSite() throws Exception {
    loadMany();
    SwingUtilities.invokeAndWait(
        () -> {
          sites.perform(Edit.wish(sites.document(), 40, Wish.ODD));
          sites.preview(MANY.moved(40, 0.5, 0.6));
          assertThat(sites.shown().document().wishes().wish(40)).isEqualTo(Wish.ODD);
          assertPictureOf(MANY.moved(40, 0.5, 0.6));
        });
  }

  /** Of these sites there is one Delaunay triangulation, so that its figures can be compared. */
  private void assertPictureOf(Points points) {
    Scene expected = Scene.of(Delaunay.triangulate(Sites.of(points, Progress.NONE), Progress.NONE));
    Scene scene = sites.shown().scene();
    assertThat(sites.shown().document().points()).isEqualTo(points);
    assertThat(scene.points()).isEqualTo(points);
    assertThat(scene.counts()).isEqualTo(expected.counts());
    assertThat(scene.edgeCount()).isEqualTo(expected.edgeCount());
    assertThat(IntStream.range(0, points.size()).filter(v -> scene.ink(v) != expected.ink(v)))
        .isEmpty();
  }

  private void awaitShown(Points points) throws Exception {
    long end = System.nanoTime() + 20_000_000_000L;
    boolean[] there = {false};
    while (!there[0] && System.nanoTime() < end) {
      SwingUtilities.invokeAndWait(
          () ->
              there[0] =
                  jobs.isIdle()
                      && sites.shown().solution().isPresent()
                      && sites.shown().document().points().equals(points));
    }
    assertThat(there[0]).isTrue();
  }

  private void load(double... pairs) {
    sites.load(new Document(Domain.SITES, Points.ofPairs(pairs)), "test");
  }
}
