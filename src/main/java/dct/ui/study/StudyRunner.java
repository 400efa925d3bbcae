package dct.ui.study;

import dct.core.Progress;
import dct.experiment.study.RunClock;
import dct.experiment.study.Study;
import dct.experiment.study.StudyRow;
import dct.experiment.study.StudyRun;
import dct.experiment.study.Trial;
import dct.ui.job.Jobs;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import javax.swing.Timer;

/**
 * Runs studies in the background and hands their rows to the event thread, some at a time; keeps
 * all rows that it ever had, so that none is computed again. Used on the event thread.
 */
final class StudyRunner {
  private static final int MILLIS_BETWEEN = 500;

  /** What is told of a run, on the event thread. */
  interface Watcher {
    /** There are more rows. */
    void rows(List<StudyRow> more);

    /** This part of the work is done. */
    void progress(double fraction, String words);

    /** The run is over, or was cancelled; these are its rows in the study's order. */
    void ended(List<StudyRow> inOrder);

    /** The run failed; the rows until then are kept. */
    void failed(Throwable cause);
  }

  private final Watcher watcher;
  private final Jobs jobs = new Jobs();
  private final Queue<StudyRow> fresh = new ConcurrentLinkedQueue<>();
  private final Map<Trial, StudyRow> kept = new LinkedHashMap<>();
  private final Timer timer = new Timer(MILLIS_BETWEEN, e -> deliver());
  private Study study; // of the kept rows
  private Run run; // null while none is running

  StudyRunner(Watcher watcher) {
    this.watcher = watcher;
    jobs.setListener(new Failures());
  }

  /** Whether a study is running. */
  boolean isRunning() {
    return run != null;
  }

  /** Begins a study and returns those of its rows that are there already. */
  List<StudyRow> start(Study wished) {
    study = wished;
    run = new Run();
    Run mine = run;
    List<StudyRow> before = List.copyOf(kept.values());
    jobs.submitSearch(
        wished.name(),
        progress ->
            StudyRun.run(
                wished,
                before,
                Runtime.getRuntime().availableProcessors(),
                fresh::add,
                mine.with(progress)),
        this::end);
    timer.start();
    return rows();
  }

  private List<StudyRow> rows() {
    return study.trials().stream().filter(kept::containsKey).map(kept::get).toList();
  }

  private void deliver() {
    List<StudyRow> more = new ArrayList<>();
    for (StudyRow row = fresh.poll(); row != null; row = fresh.poll()) {
      kept.put(row.trial(), row);
      more.add(row);
    }
    if (!more.isEmpty()) {
      watcher.rows(more);
    }
    if (run != null) {
      watcher.progress(run.fraction, run.clock.words(run.fraction));
    }
  }

  private void end(List<StudyRow> inOrder) {
    stop();
    watcher.ended(inOrder);
  }

  private void stop() {
    timer.stop();
    deliver();
    run = null;
  }

  /** Ends the run, if there is one. */
  void cancel() {
    if (run != null) {
      run.cancelled = true;
    }
  }

  /** Ends everything; nothing can be started after. */
  void shutDown() {
    cancel();
    timer.stop();
    jobs.shutDown();
  }

  /** How far a run is, and whether it shall go on; written and read by several threads. */
  private static final class Run {
    private final RunClock clock = new RunClock();
    private volatile double fraction;
    private volatile boolean cancelled;

    Progress with(Progress job) {
      return new Progress() {
        @Override
        public void report(double done, String message) {
          fraction = done;
        }

        @Override
        public boolean isCancelled() {
          return cancelled || job.isCancelled();
        }
      };
    }
  }

  private final class Failures implements Jobs.Listener {
    @Override
    public void running(String what, double fraction) {}

    @Override
    public void idle() {}

    @Override
    public void failed(String what, Throwable cause) {
      stop();
      watcher.failed(cause);
    }
  }
}
