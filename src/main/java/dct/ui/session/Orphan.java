package dct.ui.session;

import dct.core.Progress;
import dct.io.FileLease;
import dct.io.PointFile;
import dct.io.text.BadInputException;
import dct.problem.Solution;
import dct.ui.document.Document;
import dct.ui.document.Origin;
import dct.ui.document.Result;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Optional;

/** A drawing that a program which was killed had not saved. */
public final class Orphan {
  private final Path file;
  private final FileLease lease;
  private final Lane lane;
  private final Document document;
  private final JournalText.Content content;
  private final Instant time;

  private Orphan(Path file, FileLease lease, Lane lane, JournalText.Content content, Instant time) {
    this.file = file;
    this.lease = lease;
    this.lane = lane;
    this.content = content;
    this.time = time;
    document = content.document().with(result());
  }

  /** The drawing in a journal; nothing if there is none in it. */
  static Optional<Orphan> of(Path file, FileLease lease, Lane lane) throws IOException {
    if (!Files.exists(file)) {
      return Optional.empty();
    }
    Instant time = Files.getLastModifiedTime(file).toInstant();
    try (BufferedReader in = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
      return JournalText.read(in).map(content -> new Orphan(file, lease, lane, content, time));
    }
  }

  /** The result beside the journal, if it is one of the vertices as they were last. */
  private Optional<Result> result() {
    try {
      return content.view().flatMap(this::result);
    } catch (BadInputException e) {
      return Optional.empty();
    }
  }

  private Optional<Result> result(int view) {
    Optional<Solution> solution =
        PointFile.read(JournalFile.result(file), Progress.NONE).solution(Progress.NONE);
    return solution
        .filter(made -> content.document().isOf(made.instance()))
        .map(made -> Result.of(view, content.title(), made));
  }

  /** The drawing as it was last. */
  public Document document() {
    return document;
  }

  /** What it was called. */
  public String name() {
    return content.name();
  }

  /** The file that it was a changed state of, if there was one. */
  public Optional<Origin> origin() {
    return content.origin();
  }

  /** When it was changed last. */
  public Instant time() {
    return time;
  }

  /** Removes it for good. */
  public void discard() {
    lane.execute(() -> end(true));
  }

  /** Removes it, since an editor has taken it over: as soon as the journal of that is written. */
  public void handOver() {
    lane.execute(() -> end(!lane.isFailing()));
  }

  /** Leaves it for the next program. */
  public void leave() {
    lane.execute(() -> end(false));
  }

  private void end(boolean delete) {
    try (lease) {
      if (delete) {
        JournalFile.delete(file);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
