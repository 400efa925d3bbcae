package dct.problem.verify;

import dct.core.degree.LocalBound;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.problem.Post;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.stream.Collectors;

/**
 * What a file says of points and perhaps of their triangulation; immutable.
 *
 * <p>Nothing of it has been checked but its form: points are finite, edges are pairs of whole
 * numbers with one of the words for a kind.
 */
public final class Claims {
  private final String source;
  private final Map<String, Object> values; // by their names: texts, numbers, flags, pairs, lists
  private final Points points;
  private final int[] pointLines;
  private final ClaimedEdges edges; // null if the file has none
  private final ClaimedFlips flips; // null if the file has none
  private final List<ClaimedWindow> windows;
  private final Map<String, int[]> lines; // by field with lists: the line of each, where known

  /**
   * What stands in a file.
   *
   * @param source the file's name as the user gave it, or "-" for standard input
   * @param values strings, doubles, booleans, arrays of pairs and lists of arrays by the names of
   *     their fields
   * @param pointLines the line of each point
   * @param edges null if the file has no list of edges
   * @param flips null if the file has no list of flips
   * @param windows those of a certificate, if there is one
   */
  public Claims(
      String source,
      Map<String, Object> values,
      Points points,
      int[] pointLines,
      ClaimedEdges edges,
      ClaimedFlips flips,
      List<ClaimedWindow> windows) {
    this.source = source;
    this.values = values;
    this.points = points;
    this.pointLines = pointLines.clone();
    this.edges = edges;
    this.flips = flips;
    this.windows = List.copyOf(windows);
    this.lines = Map.of();
  }

  private Claims(Claims said, Map<String, int[]> lines) {
    source = said.source;
    values = said.values;
    points = said.points;
    pointLines = said.pointLines;
    edges = said.edges;
    flips = said.flips;
    windows = said.windows;
    this.lines = Map.copyOf(lines);
  }

  /** The same where it is known on which lines the lists in these fields stand. */
  public Claims at(Map<String, int[]> linesOfLists) {
    return new Claims(this, linesOfLists);
  }

  /** The line of the i-th list in the field of this name, 1 where it is not known. */
  int line(String name, int i) {
    return lines.containsKey(name) ? lines.get(name)[i] : 1;
  }

  /** The file's name as the user gave it, or "-" for standard input. */
  public String source() {
    return source;
  }

  /** What the points are said to be. */
  public Optional<Domain> domain() {
    return text("kind").flatMap(Domain::parse);
  }

  /** The points. */
  public Points points() {
    return points;
  }

  /**
   * What is said to have come after the method.
   *
   * @throws FalseClaim if that is not said
   */
  Post post() {
    return text("post")
        .flatMap(Post::parse)
        .orElseThrow(
            () ->
                new FalseClaim(
                    "the field \"post\" is none of "
                        + Arrays.stream(Post.values())
                            .map(post -> '"' + post.word() + '"')
                            .collect(Collectors.joining(", "))));
  }

  /** The line of the file that point i stands on, from 1 on. */
  public int line(int i) {
    return pointLines[i];
  }

  /** The lines of all points. */
  public int[] lines() {
    return pointLines.clone();
  }

  /** The same where nothing is known of the lines of points. */
  public Claims withoutLines() {
    return new Claims(source, values, points, new int[points.size()], edges, flips, windows);
  }

  /** Whether the file has a list of edges. */
  public boolean hasEdges() {
    return edges != null;
  }

  /** The edges; only if there are any. */
  public ClaimedEdges edges() {
    return edges;
  }

  /** Whether the file has a list of flips. */
  public boolean hasFlips() {
    return flips != null;
  }

  /** The flips in order; only if there is a list of them. */
  public ClaimedFlips flips() {
    return flips;
  }

  /**
   * What is said to have been wished of n vertices: all even where nothing is said.
   *
   * @throws FalseClaim if it is not a letter for each
   */
  ParityGoal wishes(int n) {
    return text("wishes").isEmpty()
        ? ParityGoal.allEven(n)
        : text("wishes")
            .flatMap(WishLetters::parse)
            .filter(goal -> goal.size() == n)
            .orElseThrow(
                () -> new FalseClaim("the field \"wishes\" is not " + n + " letters e, o or a"));
  }

  /**
   * The windows of the certificate.
   *
   * @param n the number of sites
   * @throws FalseClaim if they have sites that there are not
   */
  List<LocalBound> windows(int n) {
    return windows.stream().map(window -> window.among(n)).toList();
  }

  /** Whether there is a field of this name, other than the lists of points, edges and flips. */
  boolean has(String name) {
    return values.containsKey(name);
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

  /** The whole number in the field of this name; a claim without one is false. */
  long required(String name) {
    return whole(name)
        .orElseThrow(
            () -> new FalseClaim("the field \"" + name + "\" is missing or no whole number"));
  }

  /** The number in the field of this name, if it is there and a number. */
  public OptionalDouble number(String name) {
    return values.get(name) instanceof Double number
        ? OptionalDouble.of(number)
        : OptionalDouble.empty();
  }

  /** The pairs of vertices in the field of this name, one after the other, if it holds them. */
  Optional<int[]> pairs(String name) {
    return values.get(name) instanceof int[] ends ? Optional.of(ends.clone()) : Optional.empty();
  }

  /** The whole numbers in the field of this name, if it holds a list of them. */
  Optional<int[]> numbers(String name) {
    return pairs(name);
  }

  /** The lists of vertices in the field of this name, if it holds them. */
  Optional<List<int[]>> lists(String name) {
    return values.get(name) instanceof List<?> all
        ? Optional.of(all.stream().filter(int[].class::isInstance).map(int[].class::cast).toList())
        : Optional.empty();
  }

  /** The truth value in the field of this name, if it is there and one. */
  public Optional<Boolean> flag(String name) {
    return values.get(name) instanceof Boolean flag ? Optional.of(flag) : Optional.empty();
  }
}
