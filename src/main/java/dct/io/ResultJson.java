package dct.io;

import com.google.gson.FormattingStyle;
import com.google.gson.stream.JsonWriter;
import dct.core.Decimals;
import dct.core.Progress;
import dct.core.degree.DegreeCount;
import dct.core.degree.Flip;
import dct.core.degree.FlipList;
import dct.core.degree.LocalBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.Preference;
import dct.core.degree.Preferred;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import dct.core.triangulate.Triangulation;
import dct.io.format.Drawing;
import dct.io.text.BadInputException;
import dct.problem.Instance;
import dct.problem.Solution;
import dct.problem.verify.Claims;
import dct.problem.verify.WishLetters;
import java.io.BufferedWriter;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Results as JSON: the summary alone, or with all points, edges and flips.
 *
 * <p>The names and the order of the fields are a contract with the scripts that read them. The
 * lists have a point, an edge, a flip a line.
 */
public final class ResultJson {
  static final String FORMAT = "dct-result/1";
  static final String DRAWN_WISHES = "documentWishes";
  static final String GIVEN_EDGES = "givenEdges";
  private static final FormattingStyle SPACED =
      FormattingStyle.COMPACT.withSpaceAfterSeparators(true);

  private final JsonWriter json;
  private final StringBuilder text = new StringBuilder();

  private ResultJson(Writer out) {
    this.json = new JsonWriter(out);
    json.setFormattingStyle(SPACED);
    json.setHtmlSafe(false);
  }

  /** Milliseconds for reading, for the method and for what came after it. */
  public record Millis(double read, double triangulate, double post) {}

  /** A use of the writer inside the one object of a file. */
  private interface Fields {
    void write(ResultJson json) throws IOException;
  }

  /**
   * The summary as one line without its end.
   *
   * @param millis how long the steps took, if that is known
   */
  public static String summary(Solution solution, Optional<Millis> millis) {
    StringWriter out = new StringWriter();
    try {
      write(out, json -> json.summaryFields(solution, millis));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return out.toString();
  }

  /**
   * Writes the whole result to a file, or nothing.
   *
   * @throws CannotWriteException if that failed; nothing is changed then
   */
  public static void write(Path file, Solution solution, Optional<Millis> millis, Progress progress)
      throws CannotWriteException {
    AtomicFile.write(file, progress, out -> write(out, solution, millis));
  }

  /**
   * Writes the whole result to a file, or nothing; with the wishes of the document that it is shown
   * in, where those are not the ones that it was made for.
   *
   * @throws CannotWriteException if that failed; nothing is changed then
   */
  public static void write(Path file, Solution solution, ParityGoal wishes, Progress progress)
      throws CannotWriteException {
    AtomicFile.write(file, progress, out -> write(out, solution, Optional.empty(), wishes));
  }

  /**
   * Writes a drawing without its solution, and what is wished of its vertices, to a file, or
   * nothing.
   *
   * @throws CannotWriteException if that failed; nothing is changed then
   */
  public static void write(Path file, Drawing drawing, ParityGoal wishes, Progress progress)
      throws CannotWriteException {
    AtomicFile.write(
        file,
        progress,
        out ->
            write(
                out,
                json -> {
                  json.json.name("kind").value(drawing.domain().word());
                  json.wishes("wishes", wishes, ParityGoal.allEven(drawing.points().size()));
                  if (drawing.rings().isPresent()) {
                    json.rings(asGiven(drawing.rings().get()), drawing.rings().get());
                  }
                  json.points(drawing.points());
                }));
  }

  /** Writes the whole result to a stream. */
  public static void write(OutputStream out, Solution solution, Optional<Millis> millis)
      throws IOException {
    write(out, solution, millis, goal(solution));
  }

  private static ParityGoal goal(Solution solution) {
    return solution
        .wished()
        .map(Optimum::goal)
        .orElseGet(() -> ParityGoal.allEven(solution.instance().size()));
  }

  private static void write(
      OutputStream out, Solution solution, Optional<Millis> millis, ParityGoal wishes)
      throws IOException {
    write(
        out,
        json -> {
          json.json.name("format").value(FORMAT);
          json.json.name("version").value(Solution.programVersion());
          json.summaryFields(solution, millis);
          json.searchFields(solution);
          json.wishes(DRAWN_WISHES, wishes, goal(solution));
          if (solution.instance() instanceof Instance.OfRegion of) {
            json.rings(walks(of.region()), of.region().rings());
          }
          json.points(solution.instance().points());
          json.edges(solution.triangulation());
          json.given(solution.preferred().map(Preferred::preference));
          if (solution.flips().isPresent()) {
            json.flips(FlipList.of(solution.flips().get()));
          }
          json.certificate(solution.bound().windows());
        });
  }

  private void wishes(String field, ParityGoal wishes, ParityGoal usual) throws IOException {
    if (!wishes.equals(usual)) {
      json.name(field).value(WishLetters.of(wishes));
    }
  }

  /**
   * Writes the points of a document, and of what domain it is said to be, to a file, or nothing.
   *
   * @throws CannotWriteException if that failed; nothing is changed then
   */
  public static void write(Path file, PointDocument document, Progress progress)
      throws CannotWriteException {
    AtomicFile.write(file, progress, out -> write(out, document));
  }

  /** Writes the points of a document, and of what domain it is said to be, to a stream. */
  public static void write(OutputStream out, PointDocument document) throws IOException {
    write(
        out,
        json -> {
          if (document.declared().isPresent()) {
            json.json.name("kind").value(document.declared().get().word());
          }
          if (document.rings().isPresent()) {
            json.rings(asGiven(document.rings().get()), document.rings().get());
          }
          json.points(document.points());
        });
  }

  /**
   * Reads a result back.
   *
   * @throws BadInputException if there is none in the file
   */
  public static Claims read(Path file, Progress progress) {
    return PointFile.open(file, progress, ResultJson::read);
  }

  /**
   * Reads a result back from a stream.
   *
   * @param name what messages call it, "-" for standard input
   * @throws BadInputException if there is none
   */
  public static Claims read(String name, InputStream in) throws IOException {
    return JsonText.read(name, in);
  }

  /**
   * What the file of a solution would claim: it is written and read back in memory, so that {@link
   * dct.problem.verify.Verifier} sees of it what it would see of the file.
   */
  public static Claims claims(Solution solution) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try {
      write(out, solution, Optional.empty());
      return read(solution.instance().name(), new ByteArrayInputStream(out.toByteArray()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void write(OutputStream out, Fields fields) throws IOException {
    Writer writer =
        new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8), 1 << 16);
    write(writer, fields);
    writer.write('\n');
    writer.flush();
  }

  private static void write(Writer out, Fields fields) throws IOException {
    ResultJson json = new ResultJson(out);
    json.json.beginObject();
    fields.write(json);
    json.json.endObject();
  }

  private void summaryFields(Solution solution, Optional<Millis> millis) throws IOException {
    Triangulation triangulation = solution.triangulation();
    DegreeCount degrees = solution.counts();
    json.name("input").value(solution.instance().name());
    json.name("kind").value(solution.instance().domain().word());
    json.name("algorithm").value(solution.methodWord());
    json.name("post").value(solution.post().word());
    json.name("vertices").value(triangulation.vertexCount());
    json.name("edges").value(triangulation.edgeCount());
    json.name("triangles").value(triangulation.triangleCount());
    json.name("boundary").value(triangulation.boundaryCount());
    if (solution.instance() instanceof Instance.OfRegion of) {
      ringSizes(of.region().rings());
    }
    json.name("even").value(degrees.even());
    json.name("odd").value(degrees.odd());
    if (solution.flips().isPresent()) {
      flipFields(solution);
    }
    json.name("oddLowerBound").value(solution.oddBound().value());
    json.name("optimal").value(solution.isProven());
    if (solution.optimum().isPresent()) {
      optimumFields(solution);
    }
    if (solution.preferred().isPresent()) {
      preferenceFields(solution.preferred().get());
    }
    json.name("merged").value(solution.instance().merged());
    if (millis.isPresent()) {
      millis(millis.get());
    }
  }

  private void optimumFields(Solution solution) throws IOException {
    Optimum optimum = solution.optimum().get();
    json.name("boundReason").value(optimum.bound().reason());
    json.name("interrupted").value(optimum.interrupted());
    if (solution.wished().isPresent()) {
      json.name("satisfied").value(optimum.goal().size() - optimum.unmet());
      json.name("unsatisfied").value(optimum.unmet());
      json.name("unsatisfiedLowerBound").value(optimum.bound().value());
      json.name("wishes").value(WishLetters.of(optimum.goal()));
    }
  }

  private void preferenceFields(Preferred preferred) throws IOException {
    json.name("preferred").value(preferred.preference().kind().word());
    String value = Decimals.format(preferred.value());
    json.name(preferred.preference().kind().field()).jsonValue(value);
    json.name("preferenceOptimal").value(preferred.isProven());
  }

  private void flipFields(Solution solution) throws IOException {
    DegreeCount before = solution.countsBefore().orElseThrow();
    json.name("evenBefore").value(before.even());
    json.name("oddBefore").value(before.odd());
    json.name("flips").value(solution.flips().get().flips());
  }

  /** What a search was given, so that it can be repeated. */
  private void searchFields(Solution solution) throws IOException {
    if (solution.optimum().isPresent()) {
      SearchLimits limits = solution.limits();
      json.name("seed").value(limits.seed());
      if (Double.isFinite(limits.seconds())) {
        json.name("timeLimit").jsonValue(Decimals.format(limits.seconds()));
      }
    }
  }

  private void millis(Millis millis) throws IOException {
    json.name("millis").beginObject();
    json.name("read").jsonValue(tenths(millis.read()));
    json.name("triangulate").jsonValue(tenths(millis.triangulate()));
    json.name("post").jsonValue(tenths(millis.post()));
    json.endObject();
  }

  private static String tenths(double millis) {
    return Decimals.format(Math.round(millis * 10) / 10.0);
  }

  /** Begins a list whose values bring their own line breaks. */
  private void beginLines(String name) throws IOException {
    json.name(name).beginArray();
    json.setFormattingStyle(FormattingStyle.COMPACT);
  }

  private void endLines() throws IOException {
    json.endArray();
    json.setFormattingStyle(SPACED);
  }

  private void points(Points points) throws IOException {
    beginLines("points");
    for (int i = 0; i < points.size(); i++) {
      text.setLength(0);
      text.append("\n[");
      Decimals.append(text, points.x(i));
      text.append(", ");
      Decimals.append(text, points.y(i));
      json.jsonValue(text.append(']').toString());
    }
    endLines();
  }

  private void edges(Triangulation triangulation) throws IOException {
    beginLines("edgeList");
    for (int edge = 0; edge < triangulation.edgeCount(); edge++) {
      text.setLength(0);
      text.append("\n[").append(triangulation.from(edge)).append(", ");
      text.append(triangulation.to(edge)).append(", \"");
      text.append(triangulation.kind(edge).word()).append("\"]");
      json.jsonValue(text.toString());
    }
    endLines();
  }

  /** The vertices of each ring, with the region on its left. */
  private static List<int[]> walks(Region region) {
    List<int[]> walks = new ArrayList<>();
    int first = 0;
    for (int r = 0; r < region.rings().count(); r++) {
      int[] walk = new int[region.rings().size(r)];
      int position = first;
      for (int k = 0; k < walk.length; k++) {
        walk[k] = region.vertex(position);
        position = region.after(position);
      }
      walks.add(walk);
      first += walk.length;
    }
    return walks;
  }

  private static List<int[]> asGiven(Rings rings) {
    return IntStream.range(0, rings.count()).mapToObj(rings::ring).toList();
  }

  private void ringSizes(Rings rings) throws IOException {
    json.name("ringSizes").beginArray();
    for (int r = 0; r < rings.count(); r++) {
      json.value(rings.size(r));
    }
    json.endArray();
  }

  private void rings(List<int[]> walks, Rings rings) throws IOException {
    beginLines("rings");
    for (int[] walk : walks) {
      json.jsonValue("\n" + Arrays.toString(walk));
    }
    endLines();
    beginLines("fixed");
    for (int j = 0; j < rings.fixedCount(); j++) {
      json.jsonValue("\n[" + rings.fixedFrom(j) + ", " + rings.fixedTo(j) + "]");
    }
    endLines();
  }

  /** The edges that were to be kept, if there were any. */
  private void given(Optional<Preference> preference) throws IOException {
    int[] ends = preference.map(Preference::given).orElseGet(() -> new int[0]);
    if (ends.length > 0) {
      beginLines(GIVEN_EDGES);
      for (int i = 0; i < ends.length; i += 2) {
        json.jsonValue("\n[" + ends[i] + ", " + ends[i + 1] + "]");
      }
      endLines();
    }
  }

  private void certificate(List<LocalBound> windows) throws IOException {
    if (!windows.isEmpty()) {
      json.name("certificate").beginObject();
      json.name("windows").beginArray();
      for (LocalBound window : windows) {
        json.beginObject().name("unmet").value(window.unmet()).name("sites").beginArray();
        for (int v : window.sites().stream().toArray()) {
          json.value(v);
        }
        json.endArray().endObject();
      }
      json.endArray().endObject();
    }
  }

  private void flips(FlipList list) throws IOException {
    beginLines("flipList");
    for (Flip flip : list.flips()) {
      text.setLength(0);
      text.append("\n[").append(flip.u()).append(", ").append(flip.v()).append(", ");
      text.append(flip.x()).append(", ").append(flip.y());
      json.jsonValue(text.append(']').toString());
    }
    endLines();
  }
}
