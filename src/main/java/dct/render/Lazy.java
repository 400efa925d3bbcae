package dct.render;

import java.util.function.Supplier;

/** A value that is made when it is first asked for, once, whichever thread asks. */
final class Lazy<T> implements Supplier<T> {
  private Supplier<T> make; // null once the value is made
  private volatile T value;

  Lazy(Supplier<T> make) {
    this.make = make;
  }

  @Override
  public synchronized T get() {
    if (make != null) {
      value = make.get();
      make = null;
    }
    return value;
  }

  /** Whether the value is made, so that {@link #get} returns at once. */
  boolean isMade() {
    return value != null;
  }
}
