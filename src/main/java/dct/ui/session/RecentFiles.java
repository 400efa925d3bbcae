package dct.ui.session;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The files that were opened or saved last, the latest first. */
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
    List<Path> files = new ArrayList<>();
    for (int i = 0; i < MOST; i++) {
      settings.get(NAME + i).ifPresent(name -> add(files, name));
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
    List<Path> files = list();
    files.remove(whole);
    files.add(0, whole);
    set(files);
  }

  /** Forgets all. */
  public void clear() {
    set(List.of());
  }

  private void set(List<Path> files) {
    for (int i = 0; i < MOST; i++) {
      if (i < files.size()) {
        settings.put(NAME + i, files.get(i));
      } else {
        settings.remove(NAME + i);
      }
    }
  }
}
