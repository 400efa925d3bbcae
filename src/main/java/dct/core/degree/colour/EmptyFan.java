package dct.core.degree.colour;

import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * The empty triangles at one hull site p: those with no other site in them or on them.
 *
 * <p>The sites that p sees are numbered 0 … m − 1 counter-clockwise from the next site on the hull
 * to the previous one. Together they are the boundary of a polygon that is star-shaped from p, and
 * p, i, j is an empty triangle just if all sites between i and j lie strictly beyond the segment i
 * j. The pairs are found in time proportional to their number, after D. P. Dobkin, H. Edelsbrunner
 * and M. H. Overmars, <i>Searching for Empty Convex Polygons</i> (1990): each j asks j − 1, and
 * each site that it reaches passes it on to those that it saw itself, as long as the turn is
 * outward.
 *
 * <p>O(n log n) time for the order, then O(number of triangles). Exact.
 */
public final class EmptyFan {
  private final Points points;
  private final int hub;
  private final int[] sites; // the sites seen, counter-clockwise
  private final boolean flat; // the hub lies inside an edge of the hull
  private final int[] start; // start[j] … start[j + 1] − 1 are the partners of j
  private int[] partners; // i < j such that hub, i, j is an empty triangle

  private EmptyFan(HullRing ring, int k) {
    points = ring.points();
    hub = ring.site(k);
    flat = ring.isFlat(k);
    sites = seenFrom(ring.site(k + 1), ring.site(k - 1));
    start = new int[sites.length + 1];
    partners = new int[4 * sites.length];
  }

  private EmptyFan(Points points, int hub, int[] others) {
    this.points = points;
    this.hub = hub;
    flat = false;
    sites = nearest(Arrays.stream(others));
    start = new int[sites.length + 1];
    partners = new int[4 * sites.length];
  }

  /**
   * The empty triangles at a site among some others that all lie in one open half-plane before it,
   * or on one half of its boundary.
   *
   * @param most give up at more triangles than this
   * @return empty if given up
   */
  public static Optional<EmptyFan> of(Points points, int hub, int[] others, int most) {
    EmptyFan fan = new EmptyFan(points, hub, others);
    return fan.findPartners(most) ? Optional.of(fan) : Optional.empty();
  }

  /**
   * The empty triangles at the hull site at position k.
   *
   * @param most give up at more triangles than this
   * @return empty if given up
   */
  public static Optional<EmptyFan> of(HullRing ring, int k, int most) {
    EmptyFan fan = new EmptyFan(ring, k);
    return fan.findPartners(most) ? Optional.of(fan) : Optional.empty();
  }

  /** The number of sites that the hub sees. */
  public int size() {
    return sites.length;
  }

  /** The number of empty triangles. */
  public int triangles() {
    return start[sites.length];
  }

  /** The site with number j: 0 is the next one on the hull, the last one the previous. */
  public int site(int j) {
    return sites[j];
  }

  /** Where the partners of j begin; they end where those of j + 1 begin. */
  public int firstPartner(int j) {
    return start[j];
  }

  /** The partner at this place: its number is less than that of the one whose partner it is. */
  public int partner(int place) {
    return partners[place];
  }

  // ---- the sites seen

  private int[] seenFrom(int next, int previous) {
    int[] inside =
        nearest(
            IntStream.range(0, points.size())
                .filter(v -> v != hub && points.orient(hub, next, v) > 0)
                .filter(v -> points.orient(hub, v, previous) > 0));
    int[] seen = new int[inside.length + 2];
    seen[0] = next;
    System.arraycopy(inside, 0, seen, 1, inside.length);
    seen[seen.length - 1] = previous;
    return seen;
  }

  /** Sites by direction; the nearest of those in one direction hides the others. */
  private int[] nearest(IntStream others) {
    int[] order = others.boxed().sorted(this::compare).mapToInt(v -> v).toArray();
    int size = 0;
    for (int v : order) {
      if (size == 0 || points.orient(hub, order[size - 1], v) != 0) {
        order[size++] = v;
      }
    }
    return Arrays.copyOf(order, size);
  }

  private int compare(int v, int w) {
    int turn = points.orient(hub, v, w);
    return turn != 0 ? -turn : compareDistance(v, w);
  }

  /** The order of two sites in one direction from the hub. */
  private int compareDistance(int v, int w) {
    int byX = Double.compare(points.x(v), points.x(w));
    int byY = Double.compare(points.y(v), points.y(w));
    boolean right = points.x(v) > points.x(hub);
    boolean up = points.y(v) > points.y(hub);
    return byX != 0 ? (right ? byX : -byX) : (up ? byY : -byY);
  }

  // ---- the triangles

  private boolean findPartners(int most) {
    int[] head = new int[sites.length]; // the first partner of each site that may see more
    int[] stack = new int[sites.length]; // the sites that pass j on
    for (int j = 1; j < sites.length; j++) {
      head[j] = start[j];
      start[j + 1] = start[j];
      passOn(j, head, stack);
      if (start[j + 1] > most) {
        return false;
      }
    }
    return true;
  }

  private void passOn(int j, int[] head, int[] stack) {
    int top = 0;
    stack[0] = j - 1;
    while (top >= 0) {
      int i = stack[top];
      if (i > 0 && head[i] < start[i + 1] && isBeyond(partners[head[i]], i, j)) {
        stack[++top] = partners[head[i]++];
      } else {
        top--;
        add(i, j);
      }
    }
  }

  /** Whether i lies strictly beyond the segment from f to j, seen from the hub. */
  private boolean isBeyond(int f, int i, int j) {
    return points.orient(sites[f], sites[i], sites[j]) > 0;
  }

  private void add(int i, int j) {
    boolean isFlatTriangle = flat && i == 0 && j == sites.length - 1;
    if (isFlatTriangle) {
      return;
    }
    if (start[j + 1] == partners.length) {
      partners = Arrays.copyOf(partners, partners.length + partners.length / 2);
    }
    partners[start[j + 1]++] = i;
  }
}
