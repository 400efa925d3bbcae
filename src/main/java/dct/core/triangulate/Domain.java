package dct.core.triangulate;

/** What was triangulated. */
public enum Domain {
  /** The inside of a simple polygon: every vertex is on the boundary. */
  POLYGON,
  /** The convex hull of point sites. */
  SITES
}
