package dct.core.triangulate;

import java.util.List;

/**
 * What is different in a Delaunay triangulation after one of its sites has moved; immutable. It is
 * small: what it does not name is as before.
 *
 * @param site the site
 * @param x where it is now
 * @param y where it is now
 * @param merged whether another site is there, with which it is one: it has no edges then
 * @param removed the edges of the triangulation that there are no longer, by their numbers
 * @param added the edges that there were not
 * @param changed the other sites whose degree is another
 * @param degrees their degrees
 */
public record MovedSite(
    int site,
    double x,
    double y,
    boolean merged,
    List<Integer> removed,
    List<Edge> added,
    List<Integer> changed,
    List<Integer> degrees) {

  /**
   * An edge between two sites.
   *
   * @param from one of them
   * @param to the other
   * @param kind on the hull, or inside
   */
  public record Edge(int from, int to, EdgeKind kind) {
    /** Whether it ends at this site. */
    public boolean isAt(int site) {
      return from == site || to == site;
    }
  }

  /** The number of edges that the site has now. */
  public int degree() {
    return (int) added.stream().filter(edge -> edge.isAt(site)).count();
  }
}
