package dct.ui.file;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Domain;
import dct.io.CannotWriteException;
import dct.io.FileEnding;
import dct.io.FileNames;
import dct.io.FileStamp;
import dct.io.PointDocument;
import dct.io.PointFile;
import dct.io.ResultJson;
import dct.io.format.Choice;
import dct.io.text.BadInputException;
import dct.problem.Method;
import dct.problem.Solution;
import dct.problem.verify.Verdict;
import dct.problem.verify.Verdict.Check;
import dct.problem.verify.Verdict.Outcome;
import dct.ui.document.Document;
import dct.ui.document.Layout;
import dct.ui.document.Origin;
import dct.ui.document.Result;
import dct.ui.document.ResultTitle;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/** Reads and writes the files of documents, in the background. */
public final class DocumentFile {

  private static final Pattern PACKED = Pattern.compile("(?i).*\\.gz");

  private static final String DEVICE = "it is a device or a pipe, which may never end";

  private DocumentFile() {}

  /**
   * What was read.
   *
   * @param origin where it was found
   * @param own whether saving there loses nothing that the file holds
   * @param yUp whether y grows upwards in it
   * @param remark what there is to say of it; empty if nothing
   */
  record Read(Document document, Origin origin, boolean own, boolean yUp, String remark) {}

  /**
   * Reads the file that a name leads to; the points need not make a simple polygon.
   *
   * @param choice what is meant of it
   * @throws dct.io.format.SeveralShapes if it holds several shapes and none was chosen
   * @throws BadInputException if it holds no points of one ring, wishes of other vertices, or a
   *     triangulation of which anything is false
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Read read(Path typed, Choice choice, Progress progress) {
    Path file = FileNames.forOpening(typed);
    if (isDevice(file)) {
      throw new BadInputException(
          file.toString(), 0, DEVICE + "; put what it gives into a file and open that");
    }
    Optional<FileStamp> stamp = FileStamp.of(file); // first, so that a change after it is seen
    PointDocument read = PointFile.read(file, choice, progress);
    Points points = read.points();
    if (points.size() == 0) {
      throw new BadInputException(
          file.toString(), 0, "there are no points in it; choose another file");
    }
    return read(read, new Origin(file, stamp), progress);
  }

  /** Whether it is there, but holds nothing that could be read or written whole. */
  private static boolean isDevice(Path file) {
    return Files.exists(file) && !Files.isRegularFile(file) && !Files.isDirectory(file);
  }

  private static Read read(PointDocument read, Origin origin, Progress progress) {
    Optional<Verdict> verdict = read.verified(progress);
    Optional<Solution> solution = read.solution(progress);
    Points points = read.points();
    Domain domain = read.domain().application();
    Points kept = domain == Domain.SITES ? Sites.of(points, progress).points() : points;
    int merged = points.size() - kept.size();
    List<String> remarks = new ArrayList<>(read.notes());
    if (merged > 0) {
      String were =
          merged == 1 ? " site was there already and has" : " sites were there already and have";
      remarks.add(merged + were + " been merged");
    }
    verdict.flatMap(v -> v.first(Outcome.OPEN)).map(Check::detail).ifPresent(remarks::add);
    String remark = String.join("; ", remarks);
    Optional<Result> result =
        solution.filter(made -> !isAutomatic(made)).map(made -> result(domain, made));
    Layout layout = read.rings().map(Layout::of).orElse(Layout.PLAIN);
    Document document = new Document(domain, kept, layout, wishes(read, kept.size()), result);
    boolean own = read.isOwn() && !PACKED.matcher(origin.name()).matches();
    return new Read(document, origin, own, read.yUp(), remark);
  }

  private static ParityGoal wishes(PointDocument read, int n) {
    Optional<ParityGoal> wishes = read.wishes();
    if (wishes.filter(goal -> goal.size() != n).isPresent()) {
      throw new BadInputException(
          read.source(), 0, "two of its sites are at the same place; remove one and its wish");
    }
    return wishes.orElseGet(() -> ParityGoal.allEven(n));
  }

  /** Whether the window shows it of these points anyway. */
  private static boolean isAutomatic(Solution made) {
    return made.method().equals(Optional.of(Method.DELAUNAY))
        && made.flips().isEmpty()
        && made.optimum().isEmpty();
  }

  private static Result result(Domain domain, Solution made) {
    int view = domain == Domain.SITES ? Result.CANVAS : Result.OPENED;
    return Result.of(view, ResultTitle.of(made), made);
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
      if (isDevice(file)) {
        throw new CannotWriteException(file.toString(), DEVICE, null);
      }
      if (keepsAll(file)) {
        writeAll(file, document, progress);
      } else if (document.content() == Domain.REGION) {
        PointFile.write(file, document.rings(), progress);
      } else {
        PointFile.write(file, document.domain(), document.points(), progress);
      }
      return FileStamp.of(file);
    } catch (CannotWriteException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void writeAll(Path file, Document document, Progress progress)
      throws CannotWriteException {
    Optional<Result> result = document.result();
    if (result.isPresent()) {
      ResultJson.write(file, result.get().solution(), document.wishes(), progress);
    } else {
      ResultJson.write(file, document.drawing("", Optional.empty()), document.wishes(), progress);
    }
  }
}
