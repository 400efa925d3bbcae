package dct.io;

import dct.core.Progress;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.util.Optional;
import java.util.UUID;
import java.util.regex.Pattern;

/**
 * Writes a file whole or not at all.
 *
 * <p>The content goes to a temporary file in the same folder, is forced to the disk and moved into
 * place, and its folder is forced, too. Whatever fails, the old file stays as it was and no
 * temporary file stays behind; that of a writer that was killed is removed by the next one. Where
 * the target is a symbolic link, the file that it leads to is replaced, not the link. A replaced
 * file keeps its permissions. Devices and pipes are written to directly.
 */
public final class AtomicFile {
  private static final int MOST_LINKS = 40;
  private static final Pattern LEFT_OVER = Pattern.compile("\\.dct-[0-9a-f-]{36}\\.tmp");

  /** Puts content into a stream. */
  @FunctionalInterface
  public interface Content {
    /** Writes everything; need not flush, must not close. */
    void writeTo(OutputStream out) throws IOException;
  }

  private final Path typed;
  private final Path target;
  private final Progress progress;

  private AtomicFile(Path typed, Path target, Progress progress) {
    this.typed = typed;
    this.target = target;
    this.progress = progress;
  }

  /**
   * Writes the content to the file, replacing what is there.
   *
   * @param progress is asked before each block
   * @throws CannotWriteException if that failed; nothing is changed then
   * @throws java.util.concurrent.CancellationException if cancelled; nothing is changed then
   */
  public static void write(Path file, Progress progress, Content content)
      throws CannotWriteException {
    try {
      if (isDevice(file)) {
        writeDirectly(file, progress, content);
      } else {
        new AtomicFile(file, behindLinks(file), progress).write(content);
      }
    } catch (CannotWriteException e) {
      throw e;
    } catch (IOException e) {
      throw new CannotWriteException(file.toString(), CannotWriteException.reason(e), e);
    }
  }

  private static boolean isDevice(Path file) {
    return Files.exists(file) && !Files.isRegularFile(file) && !Files.isDirectory(file);
  }

  private static void writeDirectly(Path device, Progress progress, Content content)
      throws IOException {
    try (OutputStream out =
        buffered(Files.newOutputStream(device, StandardOpenOption.WRITE), progress)) {
      content.writeTo(out);
    }
  }

  private static OutputStream buffered(OutputStream out, Progress progress) {
    return new BufferedOutputStream(ProgressStreams.writing(out, progress), 1 << 16);
  }

  /** Follows symbolic links, the last of which may lead to a file that is not there yet. */
  private static Path behindLinks(Path file) throws IOException {
    Path path = file.toAbsolutePath();
    for (int links = 0; Files.isSymbolicLink(path); links++) {
      if (links == MOST_LINKS) {
        throw new FileSystemException(file.toString(), null, "its symbolic links go in a circle");
      }
      path = path.resolveSibling(Files.readSymbolicLink(path));
    }
    return path;
  }

  private void write(Content content) throws IOException {
    if (Files.isDirectory(target)) {
      throw refusal("it is a folder");
    }
    if (Files.exists(target) && !Files.isWritable(target)) {
      throw refusal("it is write-protected");
    }
    writeAside(content);
  }

  private CannotWriteException refusal(String reason) {
    return new CannotWriteException(typed.toString(), reason, null);
  }

  private void writeAside(Content content) throws IOException {
    removeLeftOvers();
    Path aside = target.resolveSibling(".dct-" + UUID.randomUUID() + ".tmp");
    try (FileLease lease =
        FileLease.take(aside)
            .orElseThrow(() -> refusal("its folder is in use by another program"))) {
      fill(lease.channel(), content);
      copyPermissions(aside);
      move(aside);
    }
    forceFolder();
  }

  private void fill(FileChannel channel, Content content) throws IOException {
    OutputStream out = buffered(Channels.newOutputStream(channel), progress);
    content.writeTo(out);
    out.flush();
    channel.force(true);
  }

  /** Removes the temporary files of writers that were killed; those at work hold their lease. */
  private void removeLeftOvers() throws IOException {
    try (DirectoryStream<Path> files =
        Files.newDirectoryStream(target.resolveSibling(""), ".dct-*.tmp")) {
      for (Path file : files) {
        if (LEFT_OVER.matcher(file.getFileName().toString()).matches()) {
          removeLeftOver(file);
        }
      }
    } catch (NotDirectoryException | AccessDeniedException | DirectoryIteratorException e) {
      // they stay
    }
  }

  private static void removeLeftOver(Path file) {
    try {
      Optional<FileLease> dead = FileLease.take(file);
      if (dead.isPresent()) {
        dead.get().close();
      }
    } catch (IOException e) {
      // it stays
    }
  }

  /** Sees that the new name is on the disk; some systems cannot open a folder, or force it. */
  private void forceFolder() {
    try (FileChannel folder =
        FileChannel.open(target.resolveSibling(""), StandardOpenOption.READ)) {
      folder.force(true);
    } catch (IOException e) {
      // the content is safe, and either the old name or the new one will be there
    }
  }

  private void copyPermissions(Path aside) throws IOException {
    PosixFileAttributeView old = Files.getFileAttributeView(target, PosixFileAttributeView.class);
    if (old != null && Files.exists(target)) {
      Files.setPosixFilePermissions(aside, old.readAttributes().permissions());
    }
  }

  private void move(Path aside) throws IOException {
    try {
      Files.move(aside, target, StandardCopyOption.ATOMIC_MOVE);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(aside, target, StandardCopyOption.REPLACE_EXISTING);
    }
  }
}
