package dct.ui.file;

import java.io.IOException;
import java.nio.file.ClosedWatchServiceException;
import java.nio.file.FileSystems;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchEvent;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;

/**
 * Tells when something may have happened to files, by what the system says of their folders. Where
 * the system cannot watch a folder, nothing is told: who needs to know looks at other times, too.
 */
final class FolderWatch implements AutoCloseable {
  private static final long QUIET_MILLIS = 100; // several events of one change are told once
  private static final int MOST_WAITS = 10; // in a folder that is never quiet

  private final Runnable changed;
  private final Optional<WatchService> service;
  private final Map<Path, WatchKey> keys = new HashMap<>(); // by the folder
  private volatile Set<Path> files = Set.of(); // absolute

  /**
   * A watch of no file yet.
   *
   * @param changed is called in a thread of the watch
   */
  FolderWatch(Runnable changed) {
    this.changed = changed;
    service = begin();
    service.ifPresent(
        watched -> {
          Thread thread = new Thread(() -> listen(watched), "folder watch");
          thread.setDaemon(true);
          thread.start();
        });
  }

  private static Optional<WatchService> begin() {
    try {
      return Optional.of(FileSystems.getDefault().newWatchService());
    } catch (IOException | UnsupportedOperationException e) {
      return Optional.empty(); // the system has none, or no more of them
    }
  }

  /** Watches these files, by their absolute names, and no others. */
  synchronized void watch(Set<Path> wanted) {
    files = Set.copyOf(wanted);
    Set<Path> folders = new java.util.HashSet<>();
    files.forEach(file -> folders.add(file.getParent()));
    keys.keySet().removeIf(folder -> !folders.contains(folder) && forget(folder));
    service.ifPresent(watched -> folders.forEach(folder -> register(watched, folder)));
  }

  private boolean forget(Path folder) {
    keys.get(folder).cancel();
    return true;
  }

  private void register(WatchService watched, Path folder) {
    WatchKey known = keys.get(folder);
    if (known != null && known.isValid()) {
      return;
    }
    try {
      keys.put(
          folder,
          folder.register(
              watched,
              StandardWatchEventKinds.ENTRY_CREATE,
              StandardWatchEventKinds.ENTRY_DELETE,
              StandardWatchEventKinds.ENTRY_MODIFY));
    } catch (IOException e) {
      keys.remove(folder); // there is no such folder any more, or no more can be watched
    }
  }

  private void listen(WatchService watched) {
    try {
      while (true) {
        boolean concerns = concerns(watched.take());
        for (int i = 0; i < MOST_WAITS; i++) {
          WatchKey next = watched.poll(QUIET_MILLIS, TimeUnit.MILLISECONDS);
          if (next == null) {
            break;
          }
          concerns |= concerns(next);
        }
        if (concerns) {
          changed.run();
        }
      }
    } catch (ClosedWatchServiceException e) {
      // the window is closed
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Takes the events of a folder; whether one of them may be about a file that is watched. */
  private boolean concerns(WatchKey key) {
    Path folder = (Path) key.watchable();
    boolean concerns = false;
    for (WatchEvent<?> event : key.pollEvents()) {
      boolean isLost = event.kind().equals(StandardWatchEventKinds.OVERFLOW);
      concerns |= isLost || files.contains(folder.resolve((Path) event.context()));
    }
    return !key.reset() || concerns; // without its folder a file is gone
  }

  @Override
  public void close() {
    service.ifPresent(
        watched -> {
          try {
            watched.close();
          } catch (IOException e) {
            // it ends with the program
          }
        });
  }
}
