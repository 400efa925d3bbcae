package dct.problem;

import dct.core.triangulate.Triangulation;
import java.util.List;
import java.util.stream.IntStream;

/**
 * In what two triangulations of the same points differ.
 *
 * @param first one of them
 * @param second the other
 * @param onlyFirst the numbers of the edges of the first that the second does not have
 * @param onlySecond the numbers of the edges of the second that the first does not have
 * @param parities the vertices that are even in one and odd in the other
 */
public record Comparison(
    Triangulation first,
    Triangulation second,
    List<Integer> onlyFirst,
    List<Integer> onlySecond,
    List<Integer> parities) {

  /** The lists are copied. */
  public Comparison {
    onlyFirst = List.copyOf(onlyFirst);
    onlySecond = List.copyOf(onlySecond);
    parities = List.copyOf(parities);
  }

  /**
   * Compares two triangulations in linear time: an edge is looked for at the end that has fewer
   * edges, and the sum of these is linear in a plane graph (Chiba and Nishizeki 1985).
   *
   * @throws IllegalArgumentException if they are not of the same points, in the same order, and of
   *     the same domain
   */
  public static Comparison of(Triangulation first, Triangulation second) {
    if (first.domain() != second.domain() || !first.points().equals(second.points())) {
      throw new IllegalArgumentException("these are triangulations of different points");
    }
    List<Integer> parities =
        IntStream.range(0, first.vertexCount())
            .filter(v -> first.isEven(v) != second.isEven(v))
            .boxed()
            .toList();
    return new Comparison(first, second, only(first, second), only(second, first), parities);
  }

  private static List<Integer> only(Triangulation mine, Triangulation other) {
    return IntStream.range(0, mine.edgeCount())
        .filter(edge -> other.edgeBetween(mine.from(edge), mine.to(edge)).isEmpty())
        .boxed()
        .toList();
  }

  /** The number of edges that both have. */
  public int common() {
    return first.edgeCount() - onlyFirst.size();
  }

  /** Whether both have the same edges. */
  public boolean isSame() {
    return onlyFirst.isEmpty();
  }
}
