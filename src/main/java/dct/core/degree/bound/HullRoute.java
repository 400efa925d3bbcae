package dct.core.degree.bound;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.EmptyFan;
import dct.core.degree.colour.HullRing;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * One of the cheapest closed walks round the hull, triangle by triangle; see {@link HullWalkBound}.
 *
 * <p>The walk from one apex is made again with all costs kept, and followed back from its end.
 */
final class HullRoute {
  private static final long MOST_COSTS = 20_000_000;
  private static final int NONE = -1;

  /**
   * A triangle of the walk.
   *
   * @param colour 0 black, 1 white; 0 where the walk is not coloured
   */
  record Triangle(int a, int b, int c, int colour) {}

  private final HullRing ring;
  private final ParityGoal goal;
  private final EmptyFan[] fans;
  private final int first; // the walk starts on the edge before this position
  private final boolean coloured;
  private final List<Triangle> triangles = new ArrayList<>();
  private final List<Integer> missed = new ArrayList<>(); // sites

  private HullRoute(HullRing ring, ParityGoal goal, EmptyFan[] fans, int first, boolean coloured) {
    this.ring = ring;
    this.goal = goal;
    this.fans = fans;
    this.first = first;
    this.coloured = coloured;
  }

  /**
   * A cheapest walk that starts and ends with an apex.
   *
   * @param fans the empty triangles at each position
   * @param first it starts on the edge before this position
   * @param apex of that edge; some walk leads back to it
   * @return empty if that would take too much memory
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Optional<HullRoute> of(
      HullRing ring,
      ParityGoal goal,
      EmptyFan[] fans,
      int first,
      int apex,
      boolean coloured,
      Progress progress) {
    HullRoute route = new HullRoute(ring, goal, fans, first, coloured);
    HullWalk walk = new HullWalk(goal.size(), coloured);
    if ((long) goal.size() * walk.layers() * (fans.length + 1) > MOST_COSTS) {
      return Optional.empty();
    }
    route.trace(walk, apex, progress);
    return Optional.of(route);
  }

  private void trace(HullWalk walk, int apex, Progress progress) {
    int h = fans.length;
    int[][] costs = new int[h + 1][];
    walk.startAt(apex);
    costs[0] = walk.costs();
    for (int s = 0; s < h; s++) {
      progress.checkCancelled();
      int position = (first + s) % h;
      walk.pass(fans[position], goal.wish(ring.site(position)));
      costs[s + 1] = walk.costs();
    }
    int state = walk.layers() * apex;
    for (int s = h - 1; s >= 0; s--) {
      state = new Step((first + s) % h, walk.layers(), costs[s], costs[s + 1]).back(state);
    }
  }

  /**
   * The triangles: for each hull site, as the first corner, the one on the edge after it, and then
   * those of the fan between that and the one on the edge before it; none where both edges have one
   * triangle in common. Those at different sites may overlap.
   */
  List<Triangle> triangles() {
    return triangles;
  }

  /** The edges of the triangles, two sites each, some more than once. */
  int[] edges() {
    return triangles.stream()
        .flatMapToInt(t -> IntStream.of(t.a, t.b, t.b, t.c, t.c, t.a))
        .toArray();
  }

  /** The sites whose wish the walk misses. */
  List<Integer> missed() {
    return missed;
  }

  /** Whether the triangles are coloured so that neighbours differ. */
  boolean isColoured() {
    return coloured;
  }

  /** The way past one hull site, from the costs on the edges before and after it. */
  private final class Step {
    private final EmptyFan fan;
    private final int hub;
    private final Wish wish;
    private final int layers;
    private final int[] before;
    private final int[] after;

    Step(int position, int layers, int[] before, int[] after) {
      fan = fans[position];
      hub = ring.site(position);
      wish = goal.wish(hub);
      this.layers = layers;
      this.before = before;
      this.after = after;
    }

    /** The state on the edge before the site, from that on the edge after it. */
    int back(int state) {
      int apex = Math.floorDiv(state, layers);
      int last = fan.size() - 1;
      int ear = apex == fan.site(last) ? layerBefore(fan.site(0), state, false) : NONE;
      if (ear != NONE) { // the triangle is that on the edge before, too, and added there
        note(false);
        return layers * fan.site(0) + ear;
      }
      int j = 1;
      while (fan.site(j) != apex) {
        j++;
      }
      return alongFan(j, state);
    }

    private int colour(int state) {
      return coloured ? Math.floorDiv(Math.floorMod(state, layers), 3) : 0;
    }

    /** A layer from which the state is reached at its cost, or NONE. */
    private int layerBefore(int apex, int state, boolean odd) {
      for (int layer = 0; layer < layers; layer++) {
        int cost = before[layers * apex + layer];
        int next = coloured ? BoundaryColouring.next(layer, odd) : 0;
        if (cost < HullWalk.UNREACHED
            && next == Math.floorMod(state, layers)
            && cost + wish.penalty(odd ? 1 : 2) == after[state]) {
          return layer;
        }
      }
      return NONE;
    }

    /** The fan ends with the triangle on the edge after the site, its apex being number j. */
    private int alongFan(int j, int state) {
      int[][] onward = onward(j);
      for (int from = j; from < fan.size() - 1; from++) {
        for (int parity = 0; parity < 2; parity++) {
          boolean odd = parity == 0; // with the two on the hull
          int layer = onward[parity][from] == NONE ? NONE : layerBefore(fan.site(from), state, odd);
          if (layer != NONE) {
            take(onward, from, parity, j, colour(state));
            note(odd);
            return layers * fan.site(from) + layer;
          }
        }
      }
      throw new IllegalStateException("no way leads to a state that was reached");
    }

    /**
     * By the parity of the triangles from a number to number j, and that number: the next number on
     * the way, itself at j, or NONE.
     */
    private int[][] onward(int j) {
      int[][] onward = new int[2][fan.size()];
      Arrays.fill(onward[0], NONE);
      Arrays.fill(onward[1], NONE);
      onward[0][j] = j;
      for (int k = j + 1; k < fan.size() - 1; k++) {
        for (int place = fan.firstPartner(k); place < fan.firstPartner(k + 1); place++) {
          int i = fan.partner(place);
          for (int parity = 0; parity < 2; parity++) {
            if (i >= j && onward[1 - parity][i] != NONE) {
              onward[parity][k] = i;
            }
          }
        }
      }
      return onward;
    }

    private void take(int[][] onward, int from, int parity, int j, int lastColour) {
      add(hub, fan.site(0), fan.site(j), lastColour);
      int k = from;
      int left = parity; // the parity of the triangles from here on
      int colour = coloured ? lastColour ^ parity : 0;
      while (k != j || left != 0) {
        int i = onward[left][k];
        add(hub, fan.site(i), fan.site(k), colour);
        colour ^= coloured ? 1 : 0;
        k = i;
        left ^= 1;
      }
    }

    private void add(int a, int b, int c, int colour) {
      triangles.add(new Triangle(a, b, c, colour));
    }

    private void note(boolean odd) {
      if (wish.penalty(odd ? 1 : 2) > 0) {
        missed.add(hub);
      }
    }
  }
}
