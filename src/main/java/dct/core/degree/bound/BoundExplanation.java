package dct.core.degree.bound;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.degree.Explanation;
import dct.core.degree.LowerBound;
import dct.core.degree.Mark;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.HullRing;
import dct.core.degree.exact.OddSetProof;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/**
 * Explains a bound with the numbers of an instance, and says what is to be drawn of it.
 *
 * <p>The bounds are computed again in the order in which {@link SiteBounds} and {@link
 * PolygonBounds} take them, up to the first that reaches the number in question; what it rests on
 * is found again as well, as far as that is needed. The first ones take linear time, the walk round
 * the hull up to a second, sets of odd vertices and windows some seconds.
 */
public final class BoundExplanation {
  private final Triangulation any;
  private final HullRing ring;
  private final ParityGoal goal;
  private final Handshake handshake;
  private final LowerBound proven;
  private final int value;
  private final Progress progress;
  private int known; // the best bound computed so far

  private BoundExplanation(
      Triangulation any, ParityGoal goal, LowerBound proven, Progress progress) {
    this.any = any;
    this.ring = HullRing.of(any);
    this.goal = goal;
    this.handshake = new Handshake(goal);
    this.proven = proven;
    value = proven.value();
    this.progress = progress;
  }

  /**
   * Why no triangulation misses fewer wishes than this.
   *
   * @param any any triangulation of the instance
   * @param proven a bound that was proven; its windows, if it has any, are believed
   * @return empty if none of the bounds of this package reaches it
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optional<Explanation> of(
      Triangulation any, ParityGoal goal, LowerBound proven, Progress progress) {
    if (any.domain() == Domain.POLYGON) {
      return ofPolygon(any, goal, proven.value());
    }
    if (any.domain() == Domain.REGION) {
      return new BoundExplanation(any, goal, proven, progress).ofRegion();
    }
    return any.triangleCount() == 0
        ? Optional.of(ofPath(any, goal))
        : new BoundExplanation(any, goal, proven, progress).ofSites();
  }

  private static Explanation ofPath(Triangulation path, ParityGoal goal) {
    List<Mark> marks = new ArrayList<>();
    for (int v = 0; v < path.vertexCount(); v++) {
      if (!goal.isGranted(path, v)) {
        marks.add(new Mark.Vertex(v, Mark.Tone.FAULT, Integer.toString(path.degree(v))));
      }
    }
    return new Explanation(
        "All sites lie on one line",
        List.of("They have one triangulation, the path along the line, and it is drawn."),
        marks);
  }

  // ---- polygons

  private static Optional<Explanation> ofPolygon(Triangulation any, ParityGoal goal, int value) {
    int n = any.vertexCount();
    if (PolygonBounds.of(n, goal).value() < value) {
      return Optional.empty();
    }
    int[] boundary = IntStream.range(0, n).toArray();
    if (goal.isAll(Wish.EVEN)) {
      return Optional.of(BoundaryCount.of(boundary, "vertices"));
    }
    Handshake handshake = new Handshake(goal);
    if (handshake.bound().value() >= value) {
      return Optional.of(HandshakeMarks.of(goal));
    }
    int colouring = handshake.roundUp(BoundaryColouring.leastUnmet(n, goal::wish));
    return Optional.of(
        colouring >= value ? ColouredBoundary.of(boundary, goal) : twoEars(any, goal));
  }

  private static Explanation twoEars(Triangulation any, ParityGoal goal) {
    List<Mark> marks = new ArrayList<>();
    for (int v = 0; v < any.vertexCount(); v++) {
      if (any.degree(v) == 2) {
        int e = any.dcel().outEdge(v);
        int[] neighbours = {any.dcel().target(e), any.dcel().target(any.dcel().rotate(e))};
        marks.add(new Mark.Area(List.of(v, neighbours[0], neighbours[1]), Mark.Tone.MAIN));
        marks.add(new Mark.Vertex(v, Mark.Tone.MAIN, "2"));
      }
    }
    int n = any.vertexCount();
    int others = n - goal.count(Wish.ODD);
    return new Explanation(
        "Two ears have even tips",
        List.of(
            "The "
                + n
                + " boundary edges lie on "
                + (n - 2)
                + " triangles, and none has three: so every triangulation has two triangles or more"
                + " with two boundary edges. The vertex between these has degree 2, which is even.",
            (others == 0 ? "All vertices are wished odd" : others + " only are not wished odd")
                + ", so that at least "
                + (others == 1 ? "1 wish is" : 2 - others + " wishes are")
                + " missed."),
        marks);
  }

  // ---- regions

  /** For wishes the count over the rings is not drawn; what it forbids is refuted. */
  private Optional<Explanation> ofRegion() {
    return countedRings()
        .or(() -> reached(handshake.bound(), () -> HandshakeMarks.of(goal)))
        .or(this::refuted);
  }

  private Optional<Explanation> countedRings() {
    if (!goal.isAll(Wish.EVEN)) {
      return Optional.empty();
    }
    List<int[]> rings = Arrays.stream(any.dcel().outerCycles()).mapToObj(this::ring).toList();
    long indivisible = rings.stream().filter(ring -> ring.length % 3 != 0).count();
    LowerBound bound = new LowerBound(indivisible == 1 ? 2 : 0, "rings counted in threes");
    return reached(
        bound,
        () ->
            rings.size() == 1
                ? BoundaryCount.of(rings.get(0), "boundary vertices")
                : RingCount.of(rings));
  }

  /** The vertices of the cycle of the outer face that this half-edge is on. */
  private int[] ring(int start) {
    Dcel dcel = any.dcel();
    return IntStream.iterate(start, e -> e >= 0, e -> dcel.next(e) == start ? -1 : dcel.next(e))
        .map(dcel::origin)
        .toArray();
  }

  // ---- sites

  private Optional<Explanation> ofSites() {
    return boundary()
        .or(() -> reached(DegreeSumBound.of(ring, goal), () -> DegreeSumMarks.of(ring, goal)))
        .or(() -> reached(LongSideBound.of(ring, goal), () -> LongSideMarks.of(ring, goal)))
        .or(() -> reached(LatticeBound.of(ring, goal, progress), this::lattice))
        .or(this::threeHullSites)
        .or(this::walk)
        .or(this::threeHullSites)
        .or(() -> windows(proven))
        .or(this::refuted)
        .or(() -> windows(SiteBounds.ofWindows(any, goal, progress)));
  }

  private Optional<Explanation> reached(LowerBound bound, Supplier<Explanation> explanation) {
    return reaches(bound) ? Optional.of(explanation.get()) : Optional.empty();
  }

  private boolean reaches(LowerBound bound) {
    known = Math.max(known, handshake.roundUp(bound).value());
    return known >= value;
  }

  private Optional<Explanation> boundary() {
    int[] boundary = IntStream.range(0, ring.size()).map(ring::site).toArray();
    if (goal.isAll(Wish.EVEN)) {
      return reached(
          BoundaryColouring.ofSites(ring, goal), () -> BoundaryCount.of(boundary, "hull sites"));
    }
    return reached(handshake.bound(), () -> HandshakeMarks.of(goal))
        .or(
            () ->
                reached(
                    BoundaryColouring.ofSites(ring, goal),
                    () -> ColouredBoundary.of(boundary, goal)));
  }

  private Explanation lattice() {
    return LatticeMarks.of(Lattice.of(any, progress).orElseThrow(), ring, goal);
  }

  private Optional<Explanation> threeHullSites() {
    return reached(
        ThreeHullSites.of(ring, goal, goal.isAll(Wish.EVEN) ? known : 0),
        () -> ThreeHullMarks.of(ring, value));
  }

  private Optional<Explanation> walk() {
    Optional<LowerBound> walked = HullWalkBound.ofWalk(ring, goal, known, progress);
    return walked.isEmpty()
        ? strips()
        : walked
            .filter(this::reaches)
            .flatMap(bound -> HullWalkBound.leastWalk(ring, goal, progress))
            .map(least -> HullWalkMarks.of(ring, least, value));
  }

  private Optional<Explanation> strips() {
    return HullWalkBound.ofStrips(ring, goal, progress)
        .filter(this::reaches)
        .map(bound -> HullWalkMarks.ofStrips(ring, bound.value()));
  }

  private Optional<Explanation> refuted() {
    return OddSetProof.of(any, goal, value, progress).map(proof -> OddSetMarks.of(proof, goal));
  }

  private Optional<Explanation> windows(LowerBound sum) {
    return sum.windows().isEmpty() || sum.value() < value
        ? Optional.empty()
        : Optional.of(WindowMarks.of(ring.points(), goal, sum.windows()));
  }
}
