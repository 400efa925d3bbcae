package dct.core.degree.bound;

import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.EmptyFan;
import java.util.Arrays;

/**
 * The costs of all ways to triangulate round the hull, vertex by vertex; see {@link HullWalkBound}.
 *
 * <p>The state on a hull edge is its apex, the third corner of its triangle. Coloured, it is also
 * the colour of that triangle and the difference of black and white hull edges so far, modulo 3, as
 * in {@link BoundaryColouring}; the states of one apex are its layers.
 */
final class HullWalk {
  static final int UNREACHED = Integer.MAX_VALUE / 2;
  private static final int COLOURED_LAYERS = 6;

  private final int layers;
  private final int[] cost; // by apex and layer, on the present hull edge

  HullWalk(int sites, boolean coloured) {
    layers = coloured ? COLOURED_LAYERS : 1;
    cost = new int[sites * layers];
    Arrays.fill(cost, UNREACHED);
  }

  /** The number of states of one apex. */
  int layers() {
    return layers;
  }

  /** Lets the walk start on the edge before a fan's hub with any apex. */
  void startAnywhere(EmptyFan fan) {
    for (int place = fan.firstPartner(fan.size() - 1); place < fan.triangles(); place++) {
      cost[layers * fan.site(fan.partner(place))] = 0;
    }
  }

  /** Lets the walk start with this apex only. */
  void startAt(int apex) {
    Arrays.fill(cost, UNREACHED);
    cost[layers * apex] = 0;
  }

  /** A copy of the costs by apex and layer, on the present hull edge. */
  int[] costs() {
    return cost.clone();
  }

  /** The least cost of a walk that has come back to the state it started in. */
  int costAt(int apex) {
    return cost[layers * apex];
  }

  /** The least cost of any walk. */
  int leastCost() {
    int least = UNREACHED;
    for (int c : cost) {
      least = Math.min(least, c);
    }
    return least;
  }

  /**
   * Goes past one hull vertex. Between the triangle on the edge before it and the one on the edge
   * after it any path of empty triangles may lie; only whether their number is odd matters.
   */
  void pass(EmptyFan fan, Wish wish) {
    int last = fan.size() - 1;
    int[] reached = reachedBefore(fan); // by number in the fan, parity of the triangles, and layer
    int[] ear = Arrays.copyOfRange(cost, layers * fan.site(0), layers * (fan.site(0) + 1));
    forget(fan);
    for (int j = last - 1; j > 0; j--) {
      for (int place = fan.firstPartner(j); place < fan.firstPartner(j + 1); place++) {
        int i = fan.partner(place);
        if (i == 0) {
          arrive(fan.site(j), reached, 2 * layers * j, wish);
        } else {
          relax(reached, 2 * layers * j, 2 * layers * i);
        }
      }
    }
    for (int layer = 0; layer < layers; layer++) {
      lower(fan.site(last), layer, false, ear[layer], wish);
    }
  }

  private int[] reachedBefore(EmptyFan fan) {
    int[] reached = new int[2 * layers * fan.size()];
    Arrays.fill(reached, UNREACHED);
    for (int j = 1; j < fan.size() - 1; j++) {
      System.arraycopy(cost, layers * fan.site(j), reached, 2 * layers * j, layers);
    }
    return reached;
  }

  private void forget(EmptyFan fan) {
    for (int j = 0; j < fan.size(); j++) {
      int from = layers * fan.site(j);
      Arrays.fill(cost, from, from + layers, UNREACHED);
    }
  }

  /** One triangle more: the parities change places. */
  private void relax(int[] reached, int from, int to) {
    for (int layer = 0; layer < layers; layer++) {
      int even = from + layer;
      int odd = even + layers;
      reached[to + layers + layer] = Math.min(reached[to + layers + layer], reached[even]);
      reached[to + layer] = Math.min(reached[to + layer], reached[odd]);
    }
  }

  /** The next hull edge is reached with this apex, after an even or an odd number of triangles. */
  private void arrive(int apex, int[] reached, int from, Wish wish) {
    for (int layer = 0; layer < layers; layer++) {
      lower(apex, layer, true, reached[from + layer], wish);
      lower(apex, layer, false, reached[from + layers + layer], wish);
    }
  }

  /**
   * A vertex with an even number of triangles, the two on the hull included, has odd degree, and
   * the colour changes at it.
   */
  private void lower(int apex, int layer, boolean odd, int before, Wish wish) {
    if (before < UNREACHED) {
      int next = layers == 1 ? 0 : BoundaryColouring.next(layer, odd);
      int after = before + wish.penalty(odd ? 1 : 2);
      cost[layers * apex + next] = Math.min(cost[layers * apex + next], after);
    }
  }
}
