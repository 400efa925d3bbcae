package dct.io.format;

import dct.problem.verify.ClaimedEdges;
import java.util.List;
import java.util.Optional;

/**
 * The triangulation that a file says it holds of the points of a shape. That it is one has not been
 * checked; ends of edges may be numbers of vertices that there are not.
 *
 * @param what what it is given by, as {@code triangles} or {@code edges}
 * @param edges its edges
 * @param count the number of its triangles; 0 if the file does not list them
 * @param rim the edges that have one triangle; none if the file does not tell
 * @param fault why the triangles cannot be a triangulation, if that is known already
 * @param flips the ends of the edges that are flipped in it, one after the other
 */
public record StoredFaces(
    String what, ClaimedEdges edges, int count, Rim rim, Optional<Fault> fault, List<int[]> flips) {

  /** Copies the list. */
  public StoredFaces {
    flips = List.copyOf(flips);
  }

  /**
   * What is wrong.
   *
   * @param line where, from 1 on
   */
  public record Fault(int line, String message) {}

  /**
   * Edges of which no triangles are listed.
   *
   * @param rim as above
   */
  public static StoredFaces of(ClaimedEdges edges, Rim rim) {
    return new StoredFaces("edges", edges, 0, rim, Optional.empty(), List.of());
  }

  /** The same with these flips. */
  public StoredFaces flipped(List<int[]> edgesInTurn) {
    return new StoredFaces(what, edges, count, rim, fault, edgesInTurn);
  }
}
