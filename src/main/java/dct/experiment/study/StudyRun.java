package dct.experiment.study;

import dct.core.Progress;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;

/**
 * Runs the trials of a study on several threads, each trial on one of them.
 *
 * <p>The rows do not depend on the number of threads, nor on which trials were done before. A
 * cancel ends the trials that are running and keeps those that are done.
 */
public final class StudyRun {
  private final Study study;
  private final Progress progress;
  private final Consumer<StudyRow> each;
  private final List<Trial> open = new ArrayList<>();
  private final Map<Trial, StudyRow> rows = new HashMap<>(); // guarded by this
  private final AtomicInteger next = new AtomicInteger();
  private final double work;
  private double done; // of the work; guarded by this
  private volatile boolean failed;

  private StudyRun(
      Study study, Collection<StudyRow> before, Consumer<StudyRow> each, Progress progress) {
    this.study = study;
    this.each = each;
    this.progress = progress;
    before.forEach(row -> rows.put(row.trial(), row));
    study.trials().stream().filter(trial -> !rows.containsKey(trial)).forEach(open::add);
    work = open.stream().mapToDouble(study::cost).sum();
  }

  /**
   * Runs the trials of which there are no rows yet.
   *
   * @param before rows of an earlier run, perhaps of other trials too
   * @param threads how many trials run at the same time
   * @param each is given each new row when it is there, one at a time
   * @param progress is told of each row, and ends the run
   * @return the rows of the study's trials in the study's order; not all of them if cancelled
   */
  public static List<StudyRow> run(
      Study study,
      Collection<StudyRow> before,
      int threads,
      Consumer<StudyRow> each,
      Progress progress) {
    return new StudyRun(study, before, each, progress).run(threads);
  }

  private List<StudyRow> run(int threads) {
    ExecutorService executor = Executors.newFixedThreadPool(threads);
    try {
      List<Future<?>> workers = new ArrayList<>();
      for (int i = 0; i < threads; i++) {
        workers.add(executor.submit(this::workThrough));
      }
      workers.forEach(StudyRun::await);
    } finally {
      executor.shutdown();
    }
    return study.trials().stream().filter(rows::containsKey).map(rows::get).toList();
  }

  private static void await(Future<?> worker) {
    try {
      worker.get();
    } catch (ExecutionException e) {
      if (e.getCause() instanceof RuntimeException cause) {
        throw cause;
      }
      throw (Error) e.getCause(); // a task without checked exceptions throws nothing else
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CancellationException();
    }
  }

  private void workThrough() {
    try {
      for (int i = next.getAndIncrement(); i < open.size() && !isOver(); ) {
        keep(study.run(open.get(i), new Inner()));
        i = next.getAndIncrement();
      }
    } catch (CancellationException e) {
      if (!isOver()) {
        throw e;
      }
    } catch (RuntimeException | Error e) {
      failed = true; // the other threads stop, too
      throw e;
    }
  }

  private boolean isOver() {
    return failed || progress.isCancelled();
  }

  private synchronized void keep(StudyRow row) {
    rows.put(row.trial(), row);
    each.accept(row);
    done += study.cost(row.trial());
    progress.report(done / work, rows.size() + " rows");
  }

  /** What a trial is given: it hears of a cancel, and its own steps are not reported. */
  private final class Inner implements Progress {
    @Override
    public void report(double fraction, String message) {}

    @Override
    public boolean isCancelled() {
      return isOver();
    }
  }
}
