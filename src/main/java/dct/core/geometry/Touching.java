package dct.core.geometry;

import dct.core.Progress;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * What can be made of rings that meet themselves or each other without crossing: at a vertex that
 * they come to again, along an edge that is gone to and fro, as where a hole is tied to its
 * outline, or with a vertex on an edge.
 *
 * <p>Takes any finite points. Neither way is right for every purpose: {@link #rings} and {@link
 * #pieces} keep every place and take the rings apart there, {@link #parted} keeps the rings and
 * moves vertices a little. In O(n log n) expected time for each of few attempts.
 */
public final class Touching {
  private Touching() {}

  /**
   * The rings into which the closed chain through the points falls apart where it comes to a vertex
   * again or to one on an edge, each as the numbers of its vertices in their order; what goes to
   * and fro only is left out. A vertex on an edge is then in several. One ring of all vertices if
   * nothing touches.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static List<int[]> rings(Points points, Progress progress) {
    int n = points.size();
    if (n < 3) {
      return List.of();
    }
    Rings chain = Rings.ofChain(points);
    Meetings meetings = Meetings.of(chain, progress);
    Loops loops = new Loops(n);
    for (int v = 0; v < n; v++) {
      Progress.check(progress, v);
      int[] along = meetings.along(v, v, chain.after(v));
      for (int k = 0; k + 1 < along.length; k++) {
        loops.add(along[k], meetings.place(along[k]));
      }
    }
    List<int[]> rings = new ArrayList<>();
    for (int[] loop : loops.finished()) {
      if (hasArea(loop, points)) {
        rings.add(loop);
      }
    }
    return rings;
  }

  private static boolean hasArea(int[] ring, Points points) {
    return ring.length > 2
        && Arrays.stream(ring).anyMatch(v -> points.orient(ring[0], ring[1], v) != 0);
  }

  /**
   * The parts of the inside of an outer ring without its holes that hang together, where rings
   * touch; each without repeated vertices but where it touches itself.
   *
   * @return nothing if no two rings touch and none touches itself, or if edges cross, a site or a
   *     fixed edge meets something, a hole is not inside, or nothing is
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optional<List<Piece>> pieces(Rings rings, Progress progress) {
    for (int r = 0; r < rings.count(); r++) {
      if (rings.size(r) < 3) {
        return Optional.empty();
      }
    }
    Meetings meetings = Meetings.of(rings, progress);
    if (meetings.isEmpty() || meetings.areCrossing()) {
      return Optional.empty();
    }
    return Faces.of(rings, meetings, progress)
        .map(faces -> new Pieces(rings, faces).all())
        .filter(pieces -> !pieces.isEmpty());
  }

  /**
   * The same ring with every vertex where it meets itself moved a hair, so that it is simple.
   *
   * @return nothing if that cannot be
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optional<Points> parted(Points points, Progress progress) {
    return parted(Rings.ofChain(points), progress).map(Rings::points);
  }

  /**
   * The same rings with every vertex where one meets itself or another moved a hair, so that they
   * bound a region; into its inside, but away from what the vertex meets there. So a hole stays a
   * hole. Fixed edges of such a vertex end at the one of its place that sees their other end.
   *
   * <p>The hair is some 10⁻¹¹ of the size of all, more where that does not do, at most 2⁻¹² of it.
   *
   * @return nothing if that cannot be, because edges cross, or sites meet something
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optional<Rings> parted(Rings rings, Progress progress) {
    return rings.ringVertices() < 3 ? Optional.empty() : new Hair(rings, progress).parted();
  }
}
