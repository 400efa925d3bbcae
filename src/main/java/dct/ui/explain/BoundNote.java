package dct.ui.explain;

import dct.problem.KnownBound;
import dct.problem.Solution;
import dct.ui.canvas.CanvasPanel;
import dct.ui.job.Jobs;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;

/**
 * Writes beside the counts of a canvas how far from the best they can be. What is said is always of
 * what is shown: of other points a bound is computed anew, in a job, and until then what takes no
 * time stands there. Lives on the event thread.
 */
public final class BoundNote {
  private static final int AT_ONCE = 2_000; // vertices; their quick bound takes a millisecond

  private final CanvasPanel canvas;
  private final Jobs jobs;
  private final BooleanSupplier on;
  private final Supplier<Optional<Solution>> shown;
  private Optional<KnownBound> known = Optional.empty();
  private Optional<Jobs.Handle> job = Optional.empty();
  private Solution asked; // what the job is for

  /**
   * A note on a canvas.
   *
   * @param on whether it is asked for
   * @param shown what the canvas shows
   */
  public BoundNote(
      CanvasPanel canvas, Jobs jobs, BooleanSupplier on, Supplier<Optional<Solution>> shown) {
    this.canvas = canvas;
    this.jobs = jobs;
    this.on = on;
    this.shown = shown;
  }

  /** Brings it up to date with what is shown. */
  public void refresh() {
    Optional<Solution> solution = on.getAsBoolean() ? shown.get() : Optional.empty();
    if (solution.isEmpty()) {
      forget();
    }
    solution.filter(now -> !now.equals(asked) && !isKnown(now)).ifPresent(this::find);
    canvas.setRemark(
        solution
            .filter(this::isKnown)
            .filter(BoundNote::isSilent)
            .map(now -> known.orElseThrow().words(now))
            .orElse(""));
  }

  /** The counts of an optimum say themselves how good it is. */
  private static boolean isSilent(Solution solution) {
    return solution.optimum().isEmpty() || solution.flips().isPresent();
  }

  private boolean isKnown(Solution solution) {
    return known.filter(bound -> bound.isOf(solution)).isPresent();
  }

  private void find(Solution solution) {
    forget();
    if (solution.instance().size() <= AT_ONCE) {
      known = Optional.of(KnownBound.quick(solution));
    }
    asked = solution;
    job =
        Optional.of(
            jobs.update(
                "Finding the bound", progress -> KnownBound.best(solution, progress), this::found));
  }

  private void found(KnownBound best) {
    known = Optional.of(best);
    job = Optional.empty();
    refresh();
  }

  private void forget() {
    job.ifPresent(Jobs.Handle::cancel);
    job = Optional.empty();
    known = Optional.empty();
    asked = null;
  }
}
