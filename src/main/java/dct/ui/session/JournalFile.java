package dct.ui.session;

import dct.core.Progress;
import dct.io.FileLease;
import dct.io.ResultJson;
import dct.ui.document.Document;
import dct.ui.document.Origin;
import dct.ui.document.Result;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import java.util.UUID;

/**
 * A journal as it is written: the state of a document first, then each change of it. Beside it lie
 * the lease of the process that writes it, and the result that the document has.
 */
final class JournalFile implements Closeable {
  static final String ENDING = ".journal";

  private final Path file;
  private final FileLease lease;
  private final FileChannel channel;
  private Document written;
  private long lines; // since the journal was begun, about

  private JournalFile(Path file, FileLease lease, FileChannel channel, Document start) {
    this.file = file;
    this.lease = lease;
    this.channel = channel;
    this.written = start;
  }

  /** Begins a journal with the whole of a document; a result follows by {@link #writeResult}. */
  static JournalFile begin(Path folder, Document document, String name, Optional<Origin> origin)
      throws IOException {
    Files.createDirectories(folder);
    Path file = folder.resolve(UUID.randomUUID() + ENDING);
    FileLease lease =
        lease(file).orElseThrow(() -> new IOException("another program writes " + file));
    try {
      FileChannel channel =
          FileChannel.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
      Document empty = Document.empty(document.domain());
      JournalFile journal = new JournalFile(file, lease, channel, empty);
      journal.begin(JournalText.head(document, name, origin), document);
      return journal;
    } catch (IOException e) {
      lease.close();
      throw e;
    }
  }

  private void begin(String head, Document document) throws IOException {
    try {
      append(head);
      write(document);
    } catch (IOException e) {
      channel.close();
      delete(file);
      throw e;
    }
  }

  /** The lease of a journal: while a process holds it, the journal is its own. */
  static Optional<FileLease> lease(Path journal) throws IOException {
    return FileLease.take(beside(journal, ".lock"));
  }

  /** The result that lies beside a journal. */
  static Path result(Path journal) {
    return beside(journal, ".json");
  }

  private static Path beside(Path journal, String ending) {
    return journal.resolveSibling(journal.getFileName().toString().replace(ENDING, ending));
  }

  /** Removes a journal and what lies beside it; its lease is the caller's to end. */
  static void delete(Path journal) throws IOException {
    Files.deleteIfExists(journal);
    Files.deleteIfExists(result(journal));
  }

  /** Appends what has changed in the vertices and their wishes; the result is left out. */
  void write(Document document) throws IOException {
    String step = JournalText.step(written, document);
    append(step);
    lines += step.length() / 16 + 1;
    written = document.with(Optional.empty());
  }

  /**
   * Puts a result of the document written last beside the journal.
   *
   * @throws java.util.concurrent.CancellationException if cancelled; it is not there then
   */
  void writeResult(Document document, Result result, Progress progress) throws IOException {
    ResultJson.write(result(file), result.solution(), document.wishes(), progress);
    append(JournalText.result(result.view(), result.title()));
    written = document;
  }

  /** Appends all of a text or, where the disk is full, nothing: steps may follow later. */
  private void append(String text) throws IOException {
    long before = channel.position();
    ByteBuffer bytes = ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
    try {
      while (bytes.hasRemaining()) {
        channel.write(bytes);
      }
    } catch (IOException e) {
      channel.truncate(before);
      throw e;
    }
  }

  /** Sees that what was written outlives also a failure of the machine. */
  void force() throws IOException {
    channel.force(false);
  }

  /** What was written last, with its result where that was written. */
  Document written() {
    return written;
  }

  /** Whether so many changes were written that a new journal would be much shorter. */
  boolean isLong() {
    return lines > 1_000_000 + 4L * written.size();
  }

  /** Ends the journal: nothing is to be kept any more. */
  @Override
  public void close() throws IOException {
    try (lease;
        channel) {
      delete(file);
    }
  }
}
