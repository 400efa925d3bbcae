package dct.ui.document;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;

/**
 * A state of what is edited; immutable.
 *
 * @param domain which of the two applications it belongs to
 * @param points the vertices of the polygon, or the sites, in the order entered
 */
public record Document(Domain domain, Points points) {

  /** A document without vertices. */
  public static Document empty(Domain domain) {
    return new Document(domain, Points.ofPairs());
  }

  /** This document with other points. */
  public Document with(Points others) {
    return new Document(domain, others);
  }

  /** The number of vertices. */
  public int size() {
    return points.size();
  }

  /** The first vertex at exactly this place, or −1. */
  public int vertexAt(double x, double y) {
    for (int v = 0; v < points.size(); v++) {
      if (points.x(v) == x && points.y(v) == y) {
        return v;
      }
    }
    return -1;
  }
}
