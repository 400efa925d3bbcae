package dct.render;

import java.util.Locale;

/** The parts of a picture, in the order in which they are drawn; files keep them apart. */
enum Part {
  POLYGON,
  DIAGONALS,
  PARTITION,
  FLIPPED,
  VERTICES,
  LABELS,
  COUNTS;

  /** What files call it. */
  String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The part that edges of this colour belong to. */
  static Part ofEdges(Ink ink) {
    return switch (ink) {
      case BOUNDARY, DEFECT -> POLYGON;
      case PARTITION -> PARTITION;
      case FLIPPED -> FLIPPED;
      default -> DIAGONALS;
    };
  }
}
