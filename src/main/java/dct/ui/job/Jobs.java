package dct.ui.job;

import dct.core.Progress;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.SwingUtilities;

/**
 * Does long work in the background, one job of a lane after the other, and hands the results to the
 * event thread. Each lane has a thread of its own, so that neither the picture nor a file waits for
 * a search. The methods are called on the event thread.
 */
public final class Jobs {

  /** What a window shows of the jobs; called on the event thread. */
  public interface Listener {
    /** A job begins or goes on; the fraction is negative while it is not known. */
    void running(String what, double fraction);

    /** No job is left. */
    void idle();

    /** A job failed, not by being cancelled. */
    void failed(String what, Throwable cause);

    /** A job has come to the list of {@link Jobs#tasks}, has begun, or has left it. */
    default void listed() {}
  }

  /** A job that was queued. */
  public interface Handle {
    /** Cancels the job; does nothing once it has ended. */
    void cancel();

    /** Cancels the job if it has not begun yet. */
    void withdraw();
  }

  /** A job that waits or runs, as the user sees it. */
  public interface Task extends Handle {
    /** What is being done. */
    String what();

    /** Whether it runs already. */
    boolean hasBegun();

    /** Whether it writes a file: that is not to be cancelled. */
    boolean isWrite();
  }

  /** What follows each other in order. */
  private enum Lane {
    /** Algorithms and searches. */
    WORK,
    /** What brings the picture up to date with the document. */
    UPDATES,
    READS,
    /** Files that are written: in order, and whole before the program ends. */
    WRITES
  }

  private static final long REPORT_NANOS = 40_000_000;

  private final Map<Lane, ExecutorService> threads = new EnumMap<>(Lane.class);
  private final List<Job<?>> waiting = new ArrayList<>(); // running or not yet begun, as queued
  private Listener listener;

  /** Jobs of which there are none yet. */
  public Jobs() {
    for (Lane lane : Lane.values()) {
      threads.put(lane, Executors.newSingleThreadExecutor(action -> thread(lane, action)));
    }
  }

  /** A thread that keeps the program alive only while files are to be written. */
  private static Thread thread(Lane lane, Runnable action) {
    Thread thread = new Thread(action, lane.name());
    thread.setDaemon(lane != Lane.WRITES);
    return thread;
  }

  /** Says who is told of progress and failures. */
  public void setListener(Listener listener) {
    this.listener = listener;
  }

  /**
   * Queues a job.
   *
   * @param what what is being done, for a person to read
   * @param work computes the result in the background
   * @param done gets the result on the event thread, unless the job is cancelled or fails
   */
  public <T> Handle submit(String what, Function<Progress, T> work, Consumer<T> done) {
    return queue(Lane.WORK, what, work, done, false);
  }

  /** Queues a job that reads a file. */
  public <T> Handle read(String what, Function<Progress, T> work, Consumer<T> done) {
    return queue(Lane.READS, what, work, done, false);
  }

  /** Queues a job that writes a file; {@link #cancelCurrent} leaves it alone. */
  public <T> Handle write(String what, Function<Progress, T> work, Consumer<T> done) {
    return queue(Lane.WRITES, what, work, done, true);
  }

  /** Queues a job that brings the picture up to date with the document. */
  public <T> Handle update(String what, Function<Progress, T> work, Consumer<T> done) {
    return queue(Lane.UPDATES, what, work, done, false);
  }

  /**
   * Queues a job whose work ends early when it is cancelled and returns the best that it has then:
   * {@code done} gets that too.
   */
  public <T> Handle submitSearch(String what, Function<Progress, T> work, Consumer<T> done) {
    return queue(Lane.WORK, what, work, done, true);
  }

  private <T> Handle queue(
      Lane lane, String what, Function<Progress, T> work, Consumer<T> done, boolean isSearch) {
    Job<T> job = new Job<>(lane, what, work, done, isSearch);
    waiting.add(job);
    listed();
    threads.get(lane).execute(job);
    return job;
  }

  private void listed() {
    if (listener != null) {
      listener.listed();
    }
  }

  /** The jobs that run or wait, in the order in which they were queued. */
  public List<Task> tasks() {
    return waiting.stream().filter(Job::isAlive).map(Task.class::cast).toList();
  }

  /** Cancels the job that the listener was told of last, unless it writes a file. */
  public void cancelCurrent() {
    current().filter(job -> !job.isWrite()).ifPresent(Job::cancel);
  }

  /** Of all jobs the first that can be cancelled, or else the first. */
  private Optional<Job<?>> current() {
    return waiting.stream()
        .filter(job -> !job.isWrite() && job.isAlive())
        .findFirst()
        .or(() -> waiting.stream().filter(Job::isAlive).findFirst());
  }

  /** Whether there are files that are not written yet. */
  public boolean isWriting() {
    return waiting.stream().anyMatch(Job::isWrite);
  }

  /** The searches and other long work, running or waiting, by what they do. */
  public List<String> work() {
    return waiting.stream().filter(job -> job.lane == Lane.WORK).map(Job::what).toList();
  }

  /** Whether nothing is running or waiting. */
  public boolean isIdle() {
    return waiting.isEmpty();
  }

  /** Cancels everything but what is to be written; nothing can be submitted after. */
  public void shutDown() {
    waiting.stream().filter(job -> !job.isWrite()).forEach(Job::cancel);
    threads.values().forEach(ExecutorService::shutdown);
  }

  /** Tells of a job, if it is the current one. */
  private void announce(Job<?> job, double fraction) {
    if (listener != null && current().filter(job::equals).isPresent()) {
      listener.running(job.what(), fraction);
    }
  }

  /** Takes a job off the list, then does what its end calls for. */
  private void ended(Job<?> job, Runnable then) {
    boolean wasCurrent = current().filter(job::equals).isPresent();
    waiting.remove(job);
    listed();
    try {
      then.run();
    } finally {
      if (waiting.isEmpty() && listener != null) {
        listener.idle();
      } else if (wasCurrent) {
        current().ifPresent(next -> announce(next, -1));
      }
    }
  }

  private void failed(Job<?> job, Throwable cause) {
    if (listener != null) {
      listener.failed(job.what(), cause);
    }
  }

  /** One piece of work in a queue. */
  private final class Job<T> implements Runnable, Progress, Task {
    private final String what;
    private final Function<Progress, T> work;
    private final Consumer<T> done;
    private final Lane lane;
    private final boolean isSearch; // a cancel ends the work, and its result still counts
    private final AtomicBoolean cancelled = new AtomicBoolean();
    private final AtomicBoolean begun = new AtomicBoolean();
    private long lastReport; // used by the working thread only

    /** A piece of work that has not begun. */
    Job(Lane lane, String what, Function<Progress, T> work, Consumer<T> done, boolean isSearch) {
      this.lane = lane;
      this.what = what;
      this.work = work;
      this.done = done;
      this.isSearch = isSearch;
    }

    @Override
    public String what() {
      return what;
    }

    /** Whether it writes a file: what is asked to be written is written, whatever is cancelled. */
    @Override
    public boolean isWrite() {
      return lane == Lane.WRITES;
    }

    @Override
    public boolean hasBegun() {
      return begun.get();
    }

    /** Whether it runs or will run. */
    boolean isAlive() {
      return hasBegun() || !isCancelled();
    }

    @Override
    public void cancel() {
      cancelled.set(true);
      SwingUtilities.invokeLater(Jobs.this::listed);
    }

    @Override
    public void withdraw() {
      if (!begun.get()) {
        cancel();
      }
    }

    private void begin() {
      begun.set(true);
      SwingUtilities.invokeLater(
          () -> {
            listed();
            announce(this, -1);
          });
    }

    /** Works, and tells of the end whatever it was: also of an error of the machine. */
    @Override
    public void run() {
      if (!isCancelled()) {
        begin();
      }
      Runnable then;
      try {
        checkCancelled();
        T result = work.apply(this);
        then = () -> finish(result);
      } catch (CancellationException e) {
        then = () -> {};
      } catch (Throwable e) {
        then = () -> failed(this, e);
      }
      Runnable end = then;
      SwingUtilities.invokeLater(() -> ended(this, end));
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
        SwingUtilities.invokeLater(() -> announce(this, fraction));
      }
    }

    @Override
    public boolean isCancelled() {
      return cancelled.get();
    }
  }
}
