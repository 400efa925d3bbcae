package dct.io;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * What a JSON file says of points and perhaps of their triangulation; immutable.
 *
 * <p>Nothing of it has been checked but its form: points are finite, edges are pairs of whole
 * numbers with one of the words for a kind.
 */
public final class StoredResult {

  /**
   * An edge as it stands in the file.
   *
   * @param from the number of one vertex, perhaps of none that there is
   * @param to the number of the other
   * @param kind what the edge is said to be
   * @param line where it stands
   */
  public record Edge(int from, int to, EdgeKind kind, int line) {}

  private final String source;
  private final Map<String, Object> values; // strings, doubles and booleans by their names
  private final Points points;
  private final int[] pointLines;
  private final EdgeColumns edges;

  StoredResult(
      String source,
      Map<String, Object> values,
      Points points,
      int[] pointLines,
      EdgeColumns edges) {
    this.source = source;
    this.values = values;
    this.points = points;
    this.pointLines = pointLines;
    this.edges = edges;
  }

  /** The file's name as the user gave it, or "-" for standard input. */
  public String source() {
    return source;
  }

  /** The points and what they are said to be, without the triangulation. */
  public PointDocument document() {
    return new PointDocument(source, domain(), points, pointLines);
  }

  /** What the points are said to be. */
  public Optional<Domain> domain() {
    return text("kind").flatMap(DomainWord::parse);
  }

  /** The points. */
  public Points points() {
    return points;
  }

  /** Whether the file has a list of edges. */
  public boolean hasEdges() {
    return edges != null;
  }

  /** The number of edges listed. */
  public int edgeCount() {
    return edges.size();
  }

  /** The edge listed as number i, from 0 on. */
  public Edge edge(int i) {
    return edges.get(i);
  }

  /** The text in the field of this name, if it is there and a text. */
  public Optional<String> text(String name) {
    return values.get(name) instanceof String text ? Optional.of(text) : Optional.empty();
  }

  /** The whole number in the field of this name, if it is there and a whole number. */
  public OptionalLong whole(String name) {
    return values.get(name) instanceof Double number && number == Math.rint(number)
        ? OptionalLong.of(number.longValue())
        : OptionalLong.empty();
  }

  /** The truth value in the field of this name, if it is there and one. */
  public Optional<Boolean> flag(String name) {
    return values.get(name) instanceof Boolean flag ? Optional.of(flag) : Optional.empty();
  }
}
