package dct.ui.job;

import dct.core.Progress;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Function;

/** One piece of work in a queue of {@link Jobs}. */
final class Job<T> implements Runnable, Progress, Jobs.Handle {
  private static final long REPORT_NANOS = 40_000_000;

  private final Jobs jobs;
  private final String what;
  private final Function<Progress, T> work;
  private final Consumer<T> done;
  private final Jobs.Lane lane;
  private final boolean isSearch; // a cancel ends the work, and its result still counts
  private final AtomicBoolean cancelled = new AtomicBoolean();
  private final AtomicBoolean begun = new AtomicBoolean();
  private long lastReport; // used by the working thread only

  /** A piece of work that has not begun. */
  Job(
      Jobs jobs,
      Jobs.Lane lane,
      String what,
      Function<Progress, T> work,
      Consumer<T> done,
      boolean isSearch) {
    this.jobs = jobs;
    this.lane = lane;
    this.what = what;
    this.work = work;
    this.done = done;
    this.isSearch = isSearch;
  }

  String what() {
    return what;
  }

  /** Whether it writes a file: what is asked to be written is written, whatever is cancelled. */
  boolean isWrite() {
    return lane == Jobs.Lane.WRITES;
  }

  boolean hasBegun() {
    return begun.get();
  }

  @Override
  public void cancel() {
    cancelled.set(true);
  }

  @Override
  public void withdraw() {
    if (!begun.get()) {
      cancel();
    }
  }

  /** Works, and tells of the end whatever it was: also of an error of the machine. */
  @Override
  public void run() {
    begun.set(true);
    Jobs.onEventThread(() -> jobs.running(this, -1));
    Runnable then;
    try {
      checkCancelled();
      T result = work.apply(this);
      then = () -> finish(result);
    } catch (CancellationException e) {
      then = () -> {};
    } catch (Throwable e) {
      then = () -> jobs.failed(this, e);
    }
    Runnable end = then;
    Jobs.onEventThread(() -> jobs.ended(this, end));
  }

  /** On the event thread: a job that was cancelled in the last moment has no effect either. */
  private void finish(T result) {
    if (isSearch || !isCancelled()) {
      done.accept(result);
    }
  }

  @Override
  public void report(double fraction, String message) {
    long now = System.nanoTime();
    if (now - lastReport > REPORT_NANOS) {
      lastReport = now;
      Jobs.onEventThread(() -> jobs.running(this, fraction));
    }
  }

  @Override
  public boolean isCancelled() {
    return cancelled.get();
  }
}
