package dct.io;

import dct.core.Progress;
import dct.core.geometry.Defect;
import dct.core.geometry.Piece;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.geometry.SimplicityCheck;
import dct.core.geometry.Touching;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** What {@code --touching} can do about rings that touch, said where they are refused. */
final class TouchHint {
  private static final String NONE = "";
  private static final String SPLIT = ", or give --touching split";
  private static final String HAIR = ", or give --touching hair";
  private static final String BOTH = SPLIT + " or --touching hair";
  private static final String PINCHED = HAIR + ", since the region hangs together there";

  private TouchHint() {}

  /**
   * What can be done, as the end of a sentence; it has been tried. Empty if nothing can.
   *
   * @param rings those of a region; nothing for a polygon
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static String of(Defect defect, Points points, Optional<Rings> rings, Progress progress) {
    return switch (defect.kind()) {
      case DUPLICATE, TOUCH, OVERLAP, SPIKE ->
          rings.map(all -> ofRegion(all, progress)).orElseGet(() -> ofPolygon(points, progress));
      default -> NONE;
    };
  }

  private static String ofRegion(Rings rings, Progress progress) {
    Optional<List<Piece>> pieces = Touching.pieces(rings, progress);
    boolean splits = pieces.filter(all -> !all.stream().allMatch(Piece::isPinched)).isPresent();
    boolean parts =
        Touching.parted(rings, progress).isPresent()
            || pieces.filter(all -> arePartedOnTheirOwn(all, rings, progress)).isPresent();
    boolean isPinched = pieces.isPresent() && !splits;
    return isPinched && parts ? PINCHED : of(splits, parts);
  }

  private static boolean arePartedOnTheirOwn(List<Piece> pieces, Rings rings, Progress progress) {
    return pieces.size() > 1
        && pieces.stream()
            .allMatch(
                piece -> Touching.parted(piece.toRings(rings.points()), progress).isPresent());
  }

  private static String ofPolygon(Points points, Progress progress) {
    boolean splits =
        Touching.rings(points, progress).stream()
            .anyMatch(ring -> ring.length < points.size() && isSimple(points, ring, progress));
    return of(splits, Touching.parted(points, progress).isPresent());
  }

  private static boolean isSimple(Points points, int[] ring, Progress progress) {
    double[] x = Arrays.stream(ring).mapToDouble(points::x).toArray();
    double[] y = Arrays.stream(ring).mapToDouble(points::y).toArray();
    return SimplicityCheck.firstDefect(Points.of(x, y), progress).isEmpty();
  }

  private static String of(boolean splits, boolean parts) {
    if (splits) {
      return parts ? BOTH : SPLIT;
    }
    return parts ? HAIR : NONE;
  }
}
