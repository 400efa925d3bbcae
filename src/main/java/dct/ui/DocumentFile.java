package dct.ui;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Domain;
import dct.io.BadInputException;
import dct.io.CannotWriteException;
import dct.io.FileEnding;
import dct.io.FileNames;
import dct.io.FileStamp;
import dct.io.PointDocument;
import dct.io.PointFile;
import dct.io.ResultJson;
import dct.ui.document.Document;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Optional;

/** Reads and writes the files of documents, in the background. */
final class DocumentFile {

  private DocumentFile() {}

  /**
   * What was read.
   *
   * @param file where it was found
   * @param stamp what the file held; nothing if it can no longer be told
   * @param merged how many sites were in it twice
   */
  record Read(Document document, Path file, Optional<FileStamp> stamp, int merged) {}

  /**
   * Reads the file that a name leads to; the points need not make a simple polygon.
   *
   * @param otherwise what the points are unless the file says so
   * @throws BadInputException if it holds no points of one ring, or wishes of other vertices
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Read read(Path typed, Domain otherwise, Progress progress) {
    Path file = FileNames.forOpening(typed);
    Optional<FileStamp> stamp = FileStamp.of(file); // first, so that a change after it is seen
    PointDocument read = PointFile.read(file, progress);
    Domain domain = read.declared().orElse(otherwise);
    PointDocument declared = read.declared(domain);
    declared.checkOneRing();
    Points points = declared.points();
    if (points.size() == 0) {
      throw new BadInputException(
          file.toString(), 0, "there are no points in it; choose another file");
    }
    Points kept = domain == Domain.SITES ? Sites.of(points, progress).points() : points;
    int merged = points.size() - kept.size();
    return new Read(document(declared, kept, merged), file, stamp, merged);
  }

  private static Document document(PointDocument read, Points points, int merged) {
    Domain domain = read.declared().orElseThrow();
    Optional<ParityGoal> wishes = read.wishes();
    if (wishes.isPresent() && merged > 0) {
      throw new BadInputException(
          read.source(), 0, "two of its sites are at the same place; remove one and its wish");
    }
    return wishes
        .map(goal -> new Document(domain, points, goal))
        .orElseGet(() -> new Document(domain, points));
  }

  /** Whether a file of this name keeps wishes and triangulation, too. */
  static boolean keepsAll(Path file) {
    return FileEnding.JSON.isOf(file.toString());
  }

  /**
   * Writes a document as the ending of the file asks for; returns what the file holds then.
   *
   * @throws UncheckedIOException if that failed; nothing is changed then
   * @throws java.util.concurrent.CancellationException if cancelled; nothing is changed then
   */
  static Optional<FileStamp> write(Path file, Document document, Progress progress) {
    try {
      if (keepsAll(file)) {
        ResultJson.write(file, document.domain(), document.points(), document.wishes(), progress);
      } else {
        PointFile.write(file, document.domain(), document.points(), progress);
      }
      return FileStamp.of(file);
    } catch (CannotWriteException e) {
      throw new UncheckedIOException(e);
    }
  }
}
