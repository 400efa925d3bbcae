package dct.io.format.plain;

import dct.io.text.BadInputException;
import java.util.ArrayList;
import java.util.List;

/** The fixed edges of a region as they stand in a text, each on a line of its own. */
final class FixedEdges {
  private final String name;
  private final List<Edge> edges = new ArrayList<>();

  /** None yet, of a text that messages call by this name. */
  FixedEdges(String name) {
    this.name = name;
  }

  private record Edge(int from, int to, int line) {}

  /** Adds the edge that stands on this line. */
  void add(int from, int to, int line) {
    edges.add(new Edge(from, to, line));
  }

  /**
   * The ends of all, two vertices an edge.
   *
   * @param vertices how many vertices there are
   * @throws BadInputException if an edge has an end that there is not, or one end only
   */
  int[] ends(int vertices) {
    int[] ends = new int[2 * edges.size()];
    for (int i = 0; i < edges.size(); i++) {
      Edge edge = edges.get(i);
      int larger = Math.max(edge.from, edge.to);
      if (larger >= vertices) {
        throw new BadInputException(
            name,
            edge.line,
            "there is no vertex v" + larger + "; number them from 0 to " + (vertices - 1));
      }
      if (edge.from == edge.to) {
        throw new BadInputException(
            name, edge.line, "the edge joins v" + larger + " with itself; name two vertices");
      }
      ends[2 * i] = edge.from;
      ends[2 * i + 1] = edge.to;
    }
    return ends;
  }
}
