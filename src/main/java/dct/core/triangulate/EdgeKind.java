package dct.core.triangulate;

/** What an edge of a triangulation is, as the thesis colours it. */
public enum EdgeKind {
  /** An edge of the polygon or of the convex hull. */
  BOUNDARY(0),
  /** A diagonal of a piece, or an interior edge of a triangulation of sites. */
  DIAGONAL(1),
  /** A diagonal of the decomposition into convex or monotone pieces. */
  PARTITION(2),
  /** A diagonal made by a flip. */
  FLIPPED(3);

  private static final EdgeKind[] BY_CODE = {BOUNDARY, DIAGONAL, PARTITION, FLIPPED};

  /** One byte for the kind, for arrays: millions of references slow down the garbage collector. */
  final byte code;

  EdgeKind(int code) {
    this.code = (byte) code;
  }

  /** The kind with this code. */
  static EdgeKind of(byte code) {
    return BY_CODE[code];
  }
}
