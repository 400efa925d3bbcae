package dct.cli;

import java.util.concurrent.CountDownLatch;

/**
 * Hears of Ctrl+C, and holds the end of the program back until what is done has been kept: open
 * while there is something to keep.
 */
final class Interruption implements AutoCloseable {
  private final CountDownLatch kept = new CountDownLatch(1);
  private final Thread hook = new Thread(this::await, "interruption");
  private volatile boolean asked;

  Interruption() {
    Runtime.getRuntime().addShutdownHook(hook);
  }

  /** Whether the program shall end. */
  boolean isAsked() {
    return asked;
  }

  private void await() {
    asked = true;
    try {
      kept.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void close() {
    kept.countDown();
    if (!asked) {
      try {
        Runtime.getRuntime().removeShutdownHook(hook);
      } catch (IllegalStateException e) {
        asked = true; // the end has just begun
      }
    }
  }
}
