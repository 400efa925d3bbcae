package dct.core.triangulate;

import java.util.Arrays;
import java.util.Optional;

/** What an edge of a triangulation is, as the thesis colours it. */
public enum EdgeKind {
  /** An edge of the polygon or of the convex hull. */
  BOUNDARY(0, "boundary"),
  /** A diagonal of a piece, or an interior edge of a triangulation of sites. */
  DIAGONAL(1, "diagonal"),
  /** A diagonal of the decomposition into convex or monotone pieces. */
  PARTITION(2, "partition"),
  /** A diagonal made by a flip. */
  FLIPPED(3, "flipped"),
  /** An edge inside a region that every triangulation of it has. */
  FIXED(4, "fixed");

  private static final EdgeKind[] BY_CODE = {BOUNDARY, DIAGONAL, PARTITION, FLIPPED, FIXED};

  /** One byte for the kind, for arrays: millions of references slow down the garbage collector. */
  final byte code;

  private final String word;

  EdgeKind(int code, String word) {
    this.code = (byte) code;
    this.word = word;
  }

  /** The word for it in files. */
  public String word() {
    return word;
  }

  /** The kind that a word stands for, or nothing for any other word. */
  public static Optional<EdgeKind> parse(String word) {
    return Arrays.stream(BY_CODE).filter(kind -> kind.word.equals(word)).findFirst();
  }

  /** The kind with this code. */
  static EdgeKind of(byte code) {
    return BY_CODE[code];
  }
}
