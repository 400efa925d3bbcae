package dct.testing;

import dct.core.Progress;
import java.util.concurrent.atomic.AtomicInteger;

/** A progress that says so many times that the computation may go on, and then that it may not. */
public final class CancelledAfter implements Progress {
  private final AtomicInteger left;

  public CancelledAfter(int questions) {
    left = new AtomicInteger(questions);
  }

  @Override
  public void report(double fraction, String message) {}

  @Override
  public boolean isCancelled() {
    return left.decrementAndGet() < 0;
  }
}
