package dct.ui.job;

import dct.core.Progress;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.SwingUtilities;

/**
 * Does long work in the background, one job after the other, and hands the results to the event
 * thread. Work that brings the picture up to date with the document does not wait for the other
 * jobs: it has a thread of its own. The methods are called on the event thread.
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
  }

  /** A job that was queued. */
  public interface Handle {
    /** Cancels the job; does nothing once it has ended. */
    void cancel();

    /** Cancels the job if it has not begun yet. */
    void withdraw();
  }

  private final ExecutorService work = thread("jobs");
  private final ExecutorService updates = thread("updates");
  private final List<Job<?>> waiting = new ArrayList<>();
  private Listener listener;

  /** A thread that does not keep the program alive. */
  private static ExecutorService thread(String name) {
    return Executors.newSingleThreadExecutor(
        action -> {
          Thread thread = new Thread(action, name);
          thread.setDaemon(true);
          return thread;
        });
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
    return queue(this.work, new Job<>(this, what, work, done, false));
  }

  /** Queues a job that brings the picture up to date with the document. */
  public <T> Handle update(String what, Function<Progress, T> work, Consumer<T> done) {
    return queue(updates, new Job<>(this, what, work, done, false));
  }

  /**
   * Queues a job whose work ends early when it is cancelled and returns the best that it has then:
   * {@code done} gets that too.
   */
  public <T> Handle submitSearch(String what, Function<Progress, T> work, Consumer<T> done) {
    return queue(this.work, new Job<>(this, what, work, done, true));
  }

  private Handle queue(ExecutorService executor, Job<?> job) {
    waiting.add(job);
    executor.execute(job);
    return job;
  }

  /** Cancels the job that is running, or else the next one. */
  public void cancelCurrent() {
    if (!waiting.isEmpty()) {
      waiting.get(0).cancel();
    }
  }

  /** Whether nothing is running or waiting. */
  public boolean isIdle() {
    return waiting.isEmpty();
  }

  /** Cancels everything; nothing can be submitted after. */
  public void shutDown() {
    List.copyOf(waiting).forEach(Job::cancel);
    work.shutdown();
    updates.shutdown();
  }

  /** Of several jobs that are running, the one queued first is the one to tell of. */
  void running(Job<?> job, double fraction) {
    if (!waiting.isEmpty() && waiting.get(0) == job && listener != null) {
      listener.running(job.what(), fraction);
    }
  }

  /** Takes a job off the list, then does what its end calls for. */
  void ended(Job<?> job, Runnable then) {
    waiting.remove(job);
    then.run();
    if (waiting.isEmpty() && listener != null) {
      listener.idle();
    }
  }

  void failed(Job<?> job, Throwable cause) {
    if (listener != null) {
      listener.failed(job.what(), cause);
    }
  }

  static void onEventThread(Runnable action) {
    SwingUtilities.invokeLater(action);
  }
}
