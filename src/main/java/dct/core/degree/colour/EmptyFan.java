package dct.core.degree.colour;

import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * The empty triangles at one site p: those with no other site in them or on them.
 *
 * <p>The sites that p sees are numbered 0 … m − 1 counter-clockwise from some direction on.
 * Together they are the boundary of a polygon that is star-shaped from p, and p, i, j is an empty
 * triangle just if j is less than half a turn from i and all sites between them lie strictly beyond
 * the segment i j. The pairs are found in time proportional to their number, after D. P. Dobkin, H.
 * Edelsbrunner and M. H. Overmars, <i>Searching for Empty Convex Polygons</i> (1990): each j asks j
 * − 1, and each site that it reaches passes it on to those that it saw itself, as long as the turn
 * is outward. At a hull site the first direction is that of the next site on the hull; at others
 * triangles that contain the first direction are left out.
 *
 * <p>O(n log n) time for the order, then O(number of triangles). Exact.
 */
public final class EmptyFan {
  private final Points points;
  private final int hub;
  private final int[] sites; // the sites seen, counter-clockwise
  private final boolean isWide; // the sites seen span half a turn or more
  private final int[] start; // start[j] … start[j + 1] − 1 are the partners of j
  private int[] partners; // i < j such that hub, i, j is an empty triangle

  private EmptyFan(Points points, int hub, boolean isWide, int[] sites) {
    this.points = points;
    this.hub = hub;
    this.isWide = isWide;
    this.sites = sites;
    start = new int[sites.length + 1];
    partners = new int[4 * sites.length];
  }

  /**
   * The empty triangles at the hull site at position k.
   *
   * @param most give up at more triangles than this
   * @return empty if given up
   */
  public static Optional<EmptyFan> of(HullRing ring, int k, int most) {
    Points points = ring.points();
    int hub = ring.site(k);
    int next = ring.site(k + 1);
    int previous = ring.site(k - 1);
    IntStream inside =
        IntStream.range(0, points.size())
            .filter(v -> v != hub && points.orient(hub, next, v) > 0)
            .filter(v -> points.orient(hub, v, previous) > 0);
    IntStream seen =
        IntStream.concat(
            IntStream.of(next),
            IntStream.concat(Arrays.stream(seen(points, hub, inside)), IntStream.of(previous)));
    return new EmptyFan(points, hub, ring.isFlat(k), seen.toArray()).withPartners(most);
  }

  /**
   * The empty triangles at a site between sites that it sees, in their order.
   *
   * @param seen what {@link #seen} says of a half-plane, or of one and then the other
   * @param isWide whether they span half a turn or more
   * @param most give up at more triangles than this
   * @return empty if given up
   */
  static Optional<EmptyFan> of(Points points, int hub, int[] seen, boolean isWide, int most) {
    return new EmptyFan(points, hub, isWide, seen).withPartners(most);
  }

  private Optional<EmptyFan> withPartners(int most) {
    return findPartners(most) ? Optional.of(this) : Optional.empty();
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

  /**
   * The sites that a hub sees, counter-clockwise: the nearest one in each direction.
   *
   * @param others some sites that all lie in one open half-plane before the hub, or on one half of
   *     its boundary
   */
  static int[] seen(Points points, int hub, IntStream others) {
    int[] order =
        others
            .boxed()
            .sorted((v, w) -> compare(points, hub, v, w))
            .mapToInt(Integer::intValue)
            .toArray();
    int size = 0;
    for (int v : order) {
      if (size == 0 || points.orient(hub, order[size - 1], v) != 0) {
        order[size++] = v;
      }
    }
    return Arrays.copyOf(order, size);
  }

  private static int compare(Points points, int hub, int v, int w) {
    int turn = points.orient(hub, v, w);
    return turn != 0 ? -turn : compareDistance(points, hub, v, w);
  }

  /** The order of two sites in one direction from the hub. */
  private static int compareDistance(Points points, int hub, int v, int w) {
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
    int top = isBefore(j - 1, j) ? 0 : -1;
    stack[0] = j - 1;
    while (top >= 0) {
      int i = stack[top];
      while (isWide && head[i] < start[i + 1] && !isBefore(partners[head[i]], j)) {
        head[i]++; // half a turn or more from j, and from all that follow
      }
      if (head[i] < start[i + 1] && isBeyond(partners[head[i]], i, j)) {
        stack[++top] = partners[head[i]++];
      } else {
        top--;
        add(i, j);
      }
    }
  }

  /** Whether j is less than half a turn from i. */
  private boolean isBefore(int i, int j) {
    return !isWide || points.orient(hub, sites[i], sites[j]) > 0;
  }

  /** Whether i lies strictly beyond the segment from f to j, seen from the hub. */
  private boolean isBeyond(int f, int i, int j) {
    return points.orient(sites[f], sites[i], sites[j]) > 0;
  }

  private void add(int i, int j) {
    if (start[j + 1] == partners.length) {
      partners = Arrays.copyOf(partners, partners.length + partners.length / 2);
    }
    partners[start[j + 1]++] = i;
  }
}
