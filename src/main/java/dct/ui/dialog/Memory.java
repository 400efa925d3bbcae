package dct.ui.dialog;

import dct.ui.session.Settings;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * Where the dialogs of the program keep what was answered last, from one run to the next. One for
 * all windows, as the dialogs are asked one at a time. Lives on the event thread.
 */
public final class Memory {
  private static Optional<Settings> settings = Optional.empty();

  private Memory() {}

  /** Keeps answers in these settings from now on; without any, nothing is kept. */
  public static void keepIn(Settings kept) {
    settings = Optional.of(kept);
  }

  /** What is kept under a name. */
  public static Optional<String> get(String name) {
    return settings.flatMap(kept -> kept.get(name));
  }

  /** The whole number that is kept under a name, if it is one. */
  public static OptionalInt number(String name) {
    return settings.map(kept -> kept.number(name)).orElse(OptionalInt.empty());
  }

  /** Keeps something. */
  public static void put(String name, Object value) {
    settings.ifPresent(kept -> kept.put(name, value));
  }
}
