package dct.io;

import java.io.Closeable;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A file that exists while someone is at work, and is locked as long: if its process dies, the file
 * stays and its lock goes, so that the next one can tell.
 *
 * <p>The lock of a file parts processes, not the threads of one; for those a list is kept. Where
 * the file system knows no locks, only that list counts.
 */
public final class FileLease implements Closeable {
  private static final Set<Path> HELD = ConcurrentHashMap.newKeySet(); // by this process
  private static final int MOST_ATTEMPTS = 100;

  private final Path file;
  private final FileChannel channel;
  private final boolean stays;

  private FileLease(Path file, FileChannel channel, boolean stays) {
    this.file = file;
    this.channel = channel;
    this.stays = stays;
  }

  /**
   * Takes the lease of a file, which is made if it is not there.
   *
   * @return nothing if another process, or this one, holds it
   * @throws IOException if the file can be neither opened nor made
   */
  public static Optional<FileLease> take(Path named) throws IOException {
    return take(named, false);
  }

  /**
   * Takes the lease of a file that stays when it is closed: where several programs take turns, each
   * then locks the same file, not one that another has just removed.
   *
   * @return nothing if another process, or this one, holds it
   * @throws IOException if the file can be neither opened nor made
   */
  public static Optional<FileLease> takeTurn(Path named) throws IOException {
    return take(named, true);
  }

  private static Optional<FileLease> take(Path named, boolean stays) throws IOException {
    Path file = named.toAbsolutePath().normalize();
    if (!HELD.add(file)) {
      return Optional.empty();
    }
    Optional<FileLease> taken = Optional.empty();
    try {
      taken = opened(file, stays);
    } finally {
      if (taken.isEmpty()) {
        HELD.remove(file);
      }
    }
    return taken;
  }

  /**
   * Takes the lease of a file that is written bit by bit, in a hidden file beside it; of a device
   * or pipe there is nothing to take.
   *
   * @throws CannotWriteException if someone holds it, or it cannot be made
   */
  public static Closeable beside(Path file) throws CannotWriteException {
    try {
      if (Files.exists(file) && !Files.isRegularFile(file)) {
        return () -> {};
      }
      Path real = Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
      return take(real.resolveSibling("." + real.getFileName() + ".lock"))
          .orElseThrow(
              () ->
                  new CannotWriteException(
                      file.toString(), "another run of the program is writing to it", null));
    } catch (CannotWriteException e) {
      throw e;
    } catch (IOException e) {
      throw new CannotWriteException(file.toString(), CannotWriteException.reason(e), e);
    }
  }

  private static Optional<FileLease> opened(Path file, boolean stays) throws IOException {
    for (int attempt = 0; attempt < MOST_ATTEMPTS; attempt++) {
      FileChannel channel =
          FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
      if (!isLockedBy(channel)) {
        channel.close();
        return Optional.empty();
      }
      if (Files.exists(file)) {
        return Optional.of(new FileLease(file, channel, stays));
      }
      channel.close(); // the holder before has just ended and removed the file
    }
    return Optional.empty();
  }

  private static boolean isLockedBy(FileChannel channel) throws IOException {
    try {
      FileLock lock = channel.tryLock();
      return lock != null;
    } catch (OverlappingFileLockException e) {
      return false;
    } catch (IOException e) {
      return true; // there are no locks here
    }
  }

  /** The open file. */
  FileChannel channel() {
    return channel;
  }

  /** Removes the file if it is still there and not to stay, and lets go. */
  @Override
  public void close() throws IOException {
    try (channel) {
      if (!stays) {
        Files.deleteIfExists(file);
      }
    } finally {
      HELD.remove(file);
    }
  }
}
