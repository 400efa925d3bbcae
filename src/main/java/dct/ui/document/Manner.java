package dct.ui.document;

import java.util.Optional;

/**
 * In what manner a document is analysed.
 *
 * @param growing whether vertices are being drawn: the last edge of a polygon is then provisional
 * @param live by what a simple polygon is triangulated at once, if by anything
 * @param hurried whether the next state follows at once, so that the triangulation need not be the
 *     same on every machine
 */
record Manner(boolean growing, Optional<LiveMethod> live, boolean hurried) {

  /** Without a triangulation of polygons. */
  static Manner plain(boolean growing) {
    return new Manner(growing, Optional.empty(), false);
  }

  Manner growing(boolean other) {
    return new Manner(other, live, hurried);
  }

  /** Whether an analysis in this manner can stand for one in that. */
  boolean suits(Manner wished) {
    return live.equals(wished.live) && (wished.hurried || !hurried);
  }
}
