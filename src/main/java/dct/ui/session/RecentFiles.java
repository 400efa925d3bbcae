package dct.ui.session;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * The files that were opened or saved last, the latest first; of several programs at a time, the
 * files of all of them are kept.
 */
public final class RecentFiles {
  /** How many are remembered. */
  public static final int MOST = 10;

  private static final String NAME = "recent.";

  private final Settings settings;

  /** Those that are remembered in these settings. */
  public RecentFiles(Settings settings) {
    this.settings = settings;
  }

  /** The files, whether they are still there or not. */
  public List<Path> list() {
    return list(settings::get);
  }

  private static List<Path> list(Function<String, Optional<String>> values) {
    List<Path> files = new ArrayList<>();
    for (int i = 0; i < MOST; i++) {
      values.apply(NAME + i).ifPresent(name -> add(files, name));
    }
    return files;
  }

  private static void add(List<Path> files, String name) {
    try {
      files.add(Path.of(name));
    } catch (InvalidPathException e) {
      // no name of a file on this system
    }
  }

  /** Puts a file first. */
  public void add(Path file) {
    Path whole = file.toAbsolutePath().normalize();
    settings.change(values -> putFirst(whole, values));
  }

  private static void putFirst(Path file, Map<String, String> values) {
    List<Path> files = list(name -> Optional.ofNullable(values.get(name)));
    files.remove(file);
    files.add(0, file);
    set(files, values);
  }

  /** Forgets all. */
  public void clear() {
    settings.change(values -> set(List.of(), values));
  }

  private static void set(List<Path> files, Map<String, String> values) {
    for (int i = 0; i < MOST; i++) {
      if (i < files.size()) {
        values.put(NAME + i, files.get(i).toString());
      } else {
        values.remove(NAME + i);
      }
    }
  }
}
