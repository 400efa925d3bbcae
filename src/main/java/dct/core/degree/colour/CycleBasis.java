package dct.core.degree.colour;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/**
 * A basis of the cycles through the centres of triangles and the midpoints of edges that some sides
 * join, each as the set of the sites that it goes round.
 */
final class CycleBasis {
  private final SignedSides sides;
  private final AllTriangles triangles;
  private final int words;
  private final List<List<int[]>> joins = new ArrayList<>(); // by node: another node, and its side
  private final int[] node; // by triangle, by edge behind them, and by ring: 1 + its number
  private long[][] rays; // by node: those crossed on the way there
  private final long[][] withLead; // by site: the cycle whose first site it is, or null
  private int rank;

  private CycleBasis(SignedSides sides) {
    this.sides = sides;
    triangles = sides.triangles();
    int n = sides.boundary().points().size();
    words = sides.raysOutside(0).length;
    node = new int[triangles.count() + triangles.edges() + sides.boundary().rings()];
    withLead = new long[n][];
  }

  /** The cycles along these sides and the edges of the hull that these lie on. */
  static List<BitSet> of(BitSet used, SignedSides sides) {
    CycleBasis basis = new CycleBasis(sides);
    basis.join(used);
    basis.walk();
    return basis.cycles();
  }

  private void join(BitSet used) {
    int outside = triangles.count() + triangles.edges(); // of the outer ring
    BitSet onHull = new BitSet();
    for (int side = used.nextSetBit(0); side >= 0; side = used.nextSetBit(side + 1)) {
      int e = triangles.edge(side);
      int k = sides.outerPosition(e);
      join(side / 3, triangles.count() + e, side);
      if (k != SignedSides.NONE && !onHull.get(k)) {
        onHull.set(k);
        join(outside + sides.boundary().ring(k), triangles.count() + e, -1 - k);
      }
    }
  }

  private void join(int a, int b, int by) {
    int i = number(a);
    int j = number(b);
    joins.get(i).add(new int[] {j, by});
    joins.get(j).add(new int[] {i, by});
  }

  private int number(int of) {
    if (node[of] == 0) {
      joins.add(new ArrayList<>());
      node[of] = joins.size();
    }
    return node[of] - 1;
  }

  /** Reaches every node from one of its component; every other join closes a cycle. */
  private void walk() {
    rays = new long[joins.size()][];
    ArrayDeque<Integer> queue = new ArrayDeque<>();
    for (int root = 0; root < rays.length; root++) {
      if (rays[root] == null) {
        rays[root] = new long[words];
        queue.add(root);
      }
      while (!queue.isEmpty()) {
        leave(queue.remove(), queue);
      }
    }
  }

  private void leave(int from, ArrayDeque<Integer> queue) {
    for (int[] join : joins.get(from)) {
      int to = join[0];
      long[] way = rays[from].clone();
      add(way, join[1] >= 0 ? sides.raysAcross(join[1]) : sides.raysOutside(-1 - join[1]));
      if (rays[to] == null) {
        rays[to] = way;
        queue.add(to);
      } else {
        add(way, rays[to]);
        reduce(way);
      }
    }
  }

  private static void add(long[] sum, long[] term) {
    for (int w = 0; w < sum.length; w++) {
      sum[w] ^= term[w];
    }
  }

  private void reduce(long[] cycle) {
    for (int w = 0; w < words; w++) {
      while (cycle[w] != 0) {
        int lead = Long.SIZE * w + Long.numberOfTrailingZeros(cycle[w]);
        if (withLead[lead] == null) {
          withLead[lead] = cycle;
          rank++;
          return;
        }
        add(cycle, withLead[lead]);
      }
    }
  }

  private List<BitSet> cycles() {
    List<BitSet> cycles = new ArrayList<>(rank);
    for (long[] cycle : withLead) {
      if (cycle != null) {
        cycles.add(BitSet.valueOf(cycle));
      }
    }
    return cycles;
  }
}
