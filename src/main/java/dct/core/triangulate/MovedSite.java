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
 * @param removed the edges that there are no longer
 * @param added the edges that there were not; one that is on the hull now, or no longer, is both
 * @param changed the other sites whose degree is another
 * @param degrees their degrees
 */
public record MovedSite(
    int site,
    double x,
    double y,
    boolean merged,
    List<Edge> removed,
    List<Edge> added,
    List<Integer> changed,
    List<Integer> degrees) {

  /**
   * An edge between two sites, with the smaller number first.
   *
   * @param from the smaller one
   * @param to the larger one
   * @param kind on the hull, or inside
   */
  public record Edge(int from, int to, EdgeKind kind) {
    static Edge of(int u, int v, EdgeKind kind) {
      return new Edge(Math.min(u, v), Math.max(u, v), kind);
    }

    /** Whether it ends at this site. */
    public boolean isAt(int site) {
      return from == site || to == site;
    }
  }

  /** Whether the site is where it was, and nothing is different. */
  public boolean isBack() {
    return removed.isEmpty();
  }

  /** The number of edges that the site has now, if it is not where it was. */
  public int degree() {
    return (int) added.stream().filter(edge -> edge.isAt(site)).count();
  }
}
