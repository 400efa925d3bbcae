package dct.cli;

import java.lang.reflect.Proxy;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * Hears of Ctrl+C, and of a polite request to end, while there is something to keep: the first asks
 * the work to stop, a second ends the program at once.
 *
 * <p>Java has no public way to hear of a second Ctrl+C, so {@code sun.misc.Signal} is used where it
 * is there; where it is not, the first one ends the program as if this were not open.
 */
final class Interruption implements AutoCloseable {
  /** What a shell reports of a program that Ctrl+C has ended. */
  static final int STATUS = 130;

  private final AtomicBoolean asked = new AtomicBoolean();
  private final Map<String, Object> before = new LinkedHashMap<>(); // the handler of each signal

  /** Listens from now on. */
  Interruption() {
    try {
      for (String signal : List.of("INT", "TERM")) {
        before.put(signal, exchange(signal, handler()));
      }
    } catch (ReflectiveOperationException e) {
      // Java was told to leave signals alone (-Xrs), or does not know them.
    }
  }

  private Object handler() throws ClassNotFoundException {
    Class<?> type = Class.forName("sun.misc.SignalHandler");
    return Proxy.newProxyInstance(
        type.getClassLoader(),
        new Class<?>[] {type},
        (proxy, method, arguments) -> {
          hear();
          return null;
        });
  }

  /** Sets the handler of a signal; returns the one before. */
  private static Object exchange(String name, Object handler) throws ReflectiveOperationException {
    Class<?> signals = Class.forName("sun.misc.Signal");
    Class<?> handlers = Class.forName("sun.misc.SignalHandler");
    Object signal = signals.getConstructor(String.class).newInstance(name);
    return signals.getMethod("handle", signals, handlers).invoke(null, signal, handler);
  }

  private void hear() {
    if (asked.getAndSet(true)) {
      Runtime.getRuntime().halt(STATUS);
    }
  }

  /** Whether the program shall end. */
  boolean isAsked() {
    return asked.get();
  }

  /**
   * The exit status of what has come to its end: that nothing was wrong, or that it was stopped.
   */
  int status() {
    return isAsked() ? STATUS : CommandLineProgram.DONE;
  }

  @Override
  public void close() {
    try {
      for (Map.Entry<String, Object> signal : before.entrySet()) {
        exchange(signal.getKey(), signal.getValue());
      }
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }
}
