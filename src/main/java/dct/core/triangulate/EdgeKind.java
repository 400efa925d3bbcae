package dct.core.triangulate;

/** What an edge of a triangulation is, as the thesis colours it. */
public enum EdgeKind {
  /** An edge of the polygon or of the convex hull. */
  BOUNDARY,
  /** A diagonal of a piece, or an interior edge of a triangulation of sites. */
  DIAGONAL,
  /** A diagonal of the decomposition into convex or monotone pieces. */
  PARTITION,
  /** A diagonal made by a flip. */
  FLIPPED
}
