package dct.render;

import java.util.function.Supplier;

/** A value that is made when it is first asked for, once, whichever thread asks. */
final class Lazy<T> implements Supplier<T> {
  private Supplier<T> make; // null once the value is made
  private T value;

  Lazy(Supplier<T> make) {
    this.make = make;
  }

  /** Whether the value is there already. */
  synchronized boolean isMade() {
    return make == null;
  }

  @Override
  public synchronized T get() {
    if (make != null) {
      value = make.get();
      make = null;
    }
    return value;
  }
}
