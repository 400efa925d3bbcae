package dct.ui.session;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * One thread that writes small files in the order asked for. It keeps the program alive until they
 * are written, and ends by itself when there is nothing to do.
 */
public final class Lane {
  private final ThreadPoolExecutor thread =
      new ThreadPoolExecutor(
          1, 1, 1, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), action -> thread(action));

  private volatile boolean failing;

  /** A lane whose thread has not begun. */
  public Lane() {
    thread.allowCoreThreadTimeOut(true);
  }

  private static Thread thread(Runnable action) {
    return new Thread(action, "session");
  }

  /** Does something after everything that was asked for before. */
  public void execute(Runnable action) {
    thread.execute(action);
  }

  /** Says whether writing has failed the last time. */
  void setFailing(boolean failing) {
    this.failing = failing;
  }

  /** Whether writing has failed the last time. */
  boolean isFailing() {
    return failing;
  }

  /** Waits until everything is done that was asked for. */
  public void await() throws InterruptedException {
    Future<?> last = thread.submit(() -> {});
    try {
      last.get();
    } catch (ExecutionException e) {
      throw new IllegalStateException(e); // it does nothing
    }
  }
}
