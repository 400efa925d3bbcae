package dct.ui.document;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.PolygonShape;
import dct.problem.Method;
import dct.problem.Solution;
import dct.ui.job.Jobs;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.function.BooleanSupplier;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The polygon in the canvas is triangulated anew whenever it changes. */
class LiveTriangulationTest {
  private static final long PATIENCE_NANOS = 30_000_000_000L;

  private final Points points = PolygonShape.TWO_OPT.generate(60, 5).points();
  private Jobs jobs;
  private Editor editor;

  @BeforeEach
  void loadAPolygon() {
    onEventThread(
        () -> {
          jobs = new Jobs();
          editor = new Editor(Domain.POLYGON, jobs);
          editor.load(new Document(Domain.POLYGON, points), "polygon");
          return null;
        });
  }

  @AfterEach
  void endJobs() {
    onEventThread(
        () -> {
          jobs.shutDown();
          return null;
        });
  }

  @Test
  void withoutItAPolygonHasNoTriangulation() {
    assertThat(solution()).isEmpty();
  }

  @Test
  void theOptimumIsShownWithItsVerdict() {
    live(LiveMethod.MOST_EVEN);
    await(() -> solution().isPresent());
    assertThat(solution().orElseThrow().isProven()).isTrue();
    assertThat(onEventThread(() -> editor.shown().scene().counts()).get(0)).contains("optimal (");
    assertThat(onEventThread(() -> editor.document().result())).as("a step").isEmpty();
  }

  @Test
  void everyMethodTriangulatesAsItsCommandDoes() {
    for (LiveMethod each : LiveMethod.all()) {
      live(each);
      await(() -> solution().isPresent());
      if (each.method().isPresent()) {
        Method method = each.method().get();
        Solution made =
            Solution.of(
                new Document(Domain.POLYGON, points).instance("", Progress.NONE),
                method,
                Progress.NONE);
        assertThat(edges(solution().orElseThrow())).as(each.title()).isEqualTo(edges(made));
      }
    }
  }

  @Test
  void itFollowsTheMouseWhileThePolygonIsSimple() {
    live(LiveMethod.MOST_EVEN);
    await(() -> solution().isPresent());
    double x = points.x(7) + 0.25;
    preview(points.moved(7, x, points.y(7)));
    await(() -> shows(x));
    assertThat(solution()).isPresent();
    double far = 100 * (points.x(7) + 100);
    preview(points.moved(7, far, points.y(7)));
    await(() -> shows(far));
    assertThat(solution()).isEmpty();
    assertThat(onEventThread(() -> editor.shown().defects())).isNotEmpty();
    onEventThread(
        () -> {
          editor.endPreview();
          return null;
        });
    await(() -> shows(points.x(7)));
    assertThat(solution()).isPresent();
  }

  @Test
  void whatStaysAfterADragIsWhatTheOptimizerMakesOfIt() {
    live(LiveMethod.MOST_EVEN);
    double x = points.x(7) + 0.25;
    preview(points.moved(7, x, points.y(7)));
    onEventThread(
        () -> {
          editor.perform(Edit.move(editor.document(), 7, x, points.y(7)));
          return null;
        });
    await(() -> shows(x) && onEventThread(() -> jobs.isIdle()));
    Solution alone =
        LiveMethod.MOST_EVEN.solve(
            onEventThread(() -> editor.document()).instance("", Progress.NONE),
            false,
            Progress.NONE);
    assertThat(edges(solution().orElseThrow())).isEqualTo(edges(alone));
  }

  @Test
  void itEndsWhenItIsSwitchedOff() {
    live(LiveMethod.MOST_EVEN);
    await(() -> solution().isPresent());
    onEventThread(
        () -> {
          editor.setLive(Optional.empty());
          return null;
        });
    await(() -> solution().isEmpty());
    assertThat(onEventThread(() -> editor.shown().scene().counts())).isEmpty();
  }

  private void live(LiveMethod method) {
    onEventThread(
        () -> {
          editor.setLive(Optional.of(method));
          return null;
        });
  }

  private void preview(Points moved) {
    onEventThread(
        () -> {
          editor.preview(moved);
          return null;
        });
  }

  private boolean shows(double x) {
    return onEventThread(() -> editor.shown().document().points().x(7) == x);
  }

  private Optional<Solution> solution() {
    return onEventThread(() -> editor.shown().solution());
  }

  private static int[] edges(Solution solution) {
    int[] ends = new int[2 * solution.triangulation().edgeCount()];
    for (int edge = 0; edge < ends.length / 2; edge++) {
      ends[2 * edge] = solution.triangulation().from(edge);
      ends[2 * edge + 1] = solution.triangulation().to(edge);
    }
    return ends;
  }

  private static void await(BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (!condition.getAsBoolean()) {
      assertThat(System.nanoTime() < end).as("in time").isTrue();
      java.util.concurrent.locks.LockSupport.parkNanos(5_000_000);
    }
  }

  private static <T> T onEventThread(Callable<T> action) {
    FutureTask<T> task = new FutureTask<>(action);
    SwingUtilities.invokeLater(task);
    try {
      return task.get();
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }
}
