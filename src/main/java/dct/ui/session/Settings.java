package dct.ui.session;

import dct.core.Progress;
import dct.io.AtomicFile;
import dct.io.CannotWriteException;
import dct.io.FileLease;
import java.io.IOException;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Properties;
import java.util.TreeMap;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;

/**
 * Words and numbers under names, in a file that is written whole or not at all. What cannot be read
 * counts as not there, what cannot be written is forgotten at the end: settings are a convenience.
 * Several programs may share the file; each changes only what was changed in it. Lives on the event
 * thread.
 */
public final class Settings {
  private static final long WAIT_NANOS = 2_000_000;
  private static final int MOST_WAITS = 1000;

  private final Path file;
  private final Lane lane;
  private final Map<String, String> values;

  /** The settings in a file, which need not be there. */
  public Settings(Path file, Lane lane) {
    this.file = file;
    this.lane = lane;
    values = read(file);
  }

  private static Map<String, String> read(Path file) {
    Properties properties = new Properties();
    try (Reader in = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
      properties.load(in);
    } catch (IOException | IllegalArgumentException e) {
      return new HashMap<>();
    }
    Map<String, String> read = new HashMap<>();
    properties.stringPropertyNames().forEach(name -> read.put(name, properties.getProperty(name)));
    return read;
  }

  /** What is set under this name. */
  public Optional<String> get(String name) {
    return Optional.ofNullable(values.get(name));
  }

  /** The whole number that is set under this name, if it is one. */
  public OptionalInt number(String name) {
    try {
      return OptionalInt.of(Integer.parseInt(values.getOrDefault(name, "")));
    } catch (NumberFormatException e) {
      return OptionalInt.empty();
    }
  }

  /** The number that is set under this name, if it is one and finite. */
  public OptionalDouble decimal(String name) {
    try {
      double number = Double.parseDouble(values.getOrDefault(name, ""));
      return Double.isFinite(number) ? OptionalDouble.of(number) : OptionalDouble.empty();
    } catch (NumberFormatException e) {
      return OptionalDouble.empty();
    }
  }

  /** Whether something is switched on under this name. */
  public boolean isOn(String name) {
    return Boolean.parseBoolean(values.get(name));
  }

  /** Sets something; it is in the file soon after. */
  public void put(String name, Object value) {
    String text = value.toString();
    if (!text.equals(values.get(name))) {
      change(all -> all.put(name, text));
    }
  }

  /** Forgets what is set under this name. */
  public void remove(String name) {
    if (values.containsKey(name)) {
      change(all -> all.remove(name));
    }
  }

  /**
   * Changes values that belong together: those that are set here, and soon after those in the file,
   * which another program may have changed meanwhile.
   */
  void change(Consumer<Map<String, String>> change) {
    change.accept(values);
    lane.execute(() -> write(change));
  }

  private void write(Consumer<Map<String, String>> change) {
    try {
      Files.createDirectories(file.getParent());
      Optional<FileLease> lease = lease();
      try {
        Map<String, String> latest = new TreeMap<>(read(file));
        change.accept(latest);
        write(latest);
      } finally {
        if (lease.isPresent()) {
          lease.get().close();
        }
      }
    } catch (IOException e) {
      // the next program begins without it
    }
  }

  /**
   * The right to write, for which the lane waits while another program writes. Without it that
   * one's change may be lost; that is all.
   */
  private Optional<FileLease> lease() throws IOException {
    Path lock = file.resolveSibling("settings.lock");
    Optional<FileLease> lease = FileLease.takeTurn(lock);
    for (int i = 0; i < MOST_WAITS && lease.isEmpty(); i++) {
      LockSupport.parkNanos(WAIT_NANOS);
      lease = FileLease.takeTurn(lock);
    }
    return lease;
  }

  private void write(Map<String, String> latest) throws CannotWriteException {
    StringBuilder text = new StringBuilder();
    latest.forEach(
        (name, value) -> text.append(name).append('=').append(escaped(value)).append('\n'));
    byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
    AtomicFile.write(file, Progress.NONE, out -> out.write(bytes));
  }

  /** As {@link Properties} read it; names hold letters, digits and dots only. */
  private static String escaped(String value) {
    String plain = value.replace("\\", "\\\\").replace("\n", "\\n").replace("\r", "\\r");
    return plain.startsWith(" ") ? "\\" + plain : plain;
  }
}
