package dct.core.degree.bound;

import dct.core.Progress;
import dct.core.degree.LocalBound;
import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.HullRing;
import dct.core.geometry.ConvexHull;
import dct.core.geometry.Points;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The bound from windows: sets of sites in convex regions, of which some miss their wishes in every
 * triangulation. Those of windows without a common site add up.
 *
 * <p>What a window has is proven by {@link dct.core.degree.exact.OddSetSearch} from the triangles
 * at its sites alone, so the cost depends on the window. Windows are found in runs along four
 * sweeps ({@link SlabWindows}) and in boxes ({@link BoxWindows}), first round the unmet sites of
 * the best triangulation known.
 *
 * <p>The number of triangles and of steps is limited; what is found within these is the bound. Of
 * more than some thousand sites each has so many triangles that no window is tried.
 */
final class WindowBound {
  private static final long MOST_STEPS_AGAIN = 30_000_000; // some seconds
  private static final long MOST_STEPS = 4_000_000; // of one way to find windows

  private final HullRing ring;
  private final ParityGoal goal;
  private final int enough;
  private final Progress progress;
  private final WindowSites sites;
  private List<LocalBound> best = List.of();

  private WindowBound(HullRing ring, ParityGoal goal, int unmet, Progress progress) {
    this.ring = ring;
    this.goal = goal;
    int less = new Handshake(goal).roundUp(unmet - 1);
    enough = less == unmet ? unmet - 1 : unmet; // a sum that is rounded up to it
    this.progress = progress;
    sites = new WindowSites(ring, progress);
  }

  /**
   * The bound, not rounded up, with its windows.
   *
   * @param ring the hull, read from the best triangulation known
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static LowerBound of(HullRing ring, ParityGoal goal, Progress progress) {
    int unmet = goal.unmet(ring.triangulation());
    return sum(new WindowBound(ring, goal, unmet, progress).find(), goal);
  }

  /** The same for those windows of a list that can be proven. */
  static LowerBound ofClaims(
      HullRing ring, ParityGoal goal, List<LocalBound> claims, Progress progress) {
    WindowProof proof = new WindowProof(goal, MOST_STEPS_AGAIN, progress);
    BitSet taken = new BitSet();
    List<LocalBound> proven = new ArrayList<>();
    for (LocalBound claim : claims) {
      if (!claim.sites().intersects(taken)
          && ConvexHull.isAlone(ring.points(), claim.sites())
          && proof.holds(ring, claim)) {
        taken.or(claim.sites());
        proven.add(claim);
      }
    }
    return sum(proven, goal);
  }

  private static LowerBound sum(List<LocalBound> windows, ParityGoal goal) {
    String fault = goal.isAll(Wish.EVEN) ? "be all even" : "be granted all wishes";
    return new LowerBound(LocalBound.sum(windows), "windows that cannot " + fault, windows);
  }

  private List<LocalBound> find() {
    Points points = ring.points();
    Comparator<Integer> byX = Comparator.comparingDouble(points::x);
    Comparator<Integer> byY = Comparator.comparingDouble(points::y);
    int[] alongX = order(byX.thenComparing(byY));
    int[] alongY = order(byY.thenComparing(byX));
    for (int[] order : List.of(alongX, alongY, reversed(alongX), reversed(alongY))) {
      if (isOpen()) {
        take(SlabWindows.find(proof(), sites, order, enough));
      }
    }
    if (isOpen() && sites.isWhole()) {
      take(BoxWindows.find(proof(), sites.whole(), alongX, alongY, centres(), enough));
    }
    return best;
  }

  private boolean isOpen() {
    return LocalBound.sum(best) < enough;
  }

  private WindowProof proof() {
    return new WindowProof(goal, MOST_STEPS, progress);
  }

  private void take(List<LocalBound> windows) {
    best = LocalBound.sum(windows) > LocalBound.sum(best) ? windows : best;
  }

  private int[] order(Comparator<Integer> direction) {
    return IntStream.range(0, ring.points().size())
        .boxed()
        .sorted(direction)
        .mapToInt(Integer::intValue)
        .toArray();
  }

  private static int[] reversed(int[] order) {
    int[] reversed = new int[order.length];
    Arrays.setAll(reversed, i -> order[order.length - 1 - i]);
    return reversed;
  }

  /** All sites, the unmet ones first. */
  private int[] centres() {
    IntStream all = IntStream.range(0, goal.size());
    return all.boxed()
        .sorted(Comparator.comparing(v -> goal.isGranted(ring.triangulation(), v)))
        .mapToInt(Integer::intValue)
        .toArray();
  }
}
