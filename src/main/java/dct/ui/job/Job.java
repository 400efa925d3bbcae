package dct.ui.job;

import dct.core.Progress;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Function;

/** One piece of work in the queue of {@link Jobs}. */
final class Job<T> implements Runnable, Progress, Jobs.Handle {
  private static final long REPORT_NANOS = 40_000_000;

  private final Jobs jobs;
  private final String what;
  private final Function<Progress, T> work;
  private final Consumer<T> done;
  private final boolean isSearch; // a cancel ends the work, and its result still counts
  private final AtomicBoolean cancelled = new AtomicBoolean();
  private final AtomicBoolean begun = new AtomicBoolean();
  private long lastReport; // used by the working thread only

  Job(Jobs jobs, String what, Function<Progress, T> work, Consumer<T> done, boolean isSearch) {
    this.jobs = jobs;
    this.what = what;
    this.work = work;
    this.done = done;
    this.isSearch = isSearch;
  }

  String what() {
    return what;
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

  @Override
  public void run() {
    Jobs.onEventThread(() -> jobs.running(this, -1));
    Runnable then;
    try {
      begun.set(true);
      checkCancelled();
      T result = work.apply(this);
      then = () -> finish(result);
    } catch (CancellationException e) {
      then = () -> {};
    } catch (RuntimeException | OutOfMemoryError | StackOverflowError e) {
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
