package dct.problem.verify;

import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** What a file says of the rings and the fixed edges of a region. */
public final class ClaimedRings {
  /** The field with the vertices of each ring. */
  static final String RINGS = "rings";

  /** The field with the ends of the fixed edges. */
  static final String FIXED = "fixed";

  /** The field with the number of vertices of each ring. */
  static final String SIZES = "ringSizes";

  private ClaimedRings() {}

  /** The fields that only a region has. */
  static List<String> fields() {
    return List.of(RINGS, FIXED, SIZES);
  }

  /**
   * The rings, one through all points in their order where nothing is said, with the fixed edges.
   * That they bound a region has not been checked.
   *
   * @throws FalseClaim if they have vertices that there are not, or one twice
   */
  public static Rings of(Claims claims) {
    Points points = claims.points();
    Optional<List<int[]>> rings = claims.lists(RINGS);
    FalseClaim.unless(
        rings.isPresent() || !claims.has(RINGS),
        "the field \"" + RINGS + "\" is no list of lists of vertices");
    Optional<int[]> fixed = claims.pairs(FIXED);
    FalseClaim.unless(
        fixed.isPresent() || !claims.has(FIXED),
        "the field \"" + FIXED + "\" is no list of pairs of vertices");
    FalseClaim.unless(
        rings.isEmpty()
            || (!rings.get().isEmpty() && rings.get().stream().allMatch(ring -> ring.length > 0)),
        "the field \"" + RINGS + "\" has no ring, or one without vertices");
    int[] ends = fixed.orElseGet(() -> new int[0]);
    checkRings(claims, rings.orElse(List.of()));
    checkFixed(claims, ends);
    if (rings.isEmpty() && ends.length == 0) {
      return Rings.ofChain(points);
    }
    return Rings.of(points, rings.orElseGet(() -> List.of(all(points.size()))), ends);
  }

  private static void checkRings(Claims claims, List<int[]> rings) {
    boolean[] isSeen = new boolean[claims.points().size()];
    for (int r = 0; r < rings.size(); r++) {
      int line = claims.line(RINGS, r);
      for (int v : rings.get(r)) {
        checkVertex(claims, v, line);
        FalseClaim.unless(!isSeen[v], line, "vertex " + v + " is on two rings, or twice on one");
        isSeen[v] = true;
      }
    }
  }

  private static void checkFixed(Claims claims, int... ends) {
    for (int k = 0; k < ends.length; k++) {
      int line = claims.line(FIXED, k / 2);
      checkVertex(claims, ends[k], line);
      boolean isEdge = k % 2 == 0 || ends[k] != ends[k - 1];
      FalseClaim.unless(isEdge, line, "a fixed edge joins vertex " + ends[k] + " with itself");
    }
  }

  private static void checkVertex(Claims claims, int v, int line) {
    boolean isThere = 0 <= v && v < claims.points().size();
    FalseClaim.unless(isThere, line, "there is no vertex " + v);
  }

  private static int[] all(int n) {
    int[] ring = new int[n];
    Arrays.setAll(ring, v -> v);
    return ring;
  }

  /**
   * Checks that the rings are written as results have them: each with the region on its left, all
   * of their sizes named.
   *
   * @throws FalseClaim if they are not
   */
  static void check(Claims claims, Region region) {
    Rings rings = region.rings();
    int first = 0;
    for (int r = 0; r < rings.count(); r++) {
      boolean isRight = region.vertex(region.after(first)) == rings.after(region.vertex(first));
      FalseClaim.unless(
          isRight,
          r == 0
              ? "the outer ring runs clockwise, not counter-clockwise"
              : "the ring of hole " + r + " runs counter-clockwise, not clockwise");
      first += rings.size(r);
    }
    int[] sizes = new int[rings.count()];
    Arrays.setAll(sizes, rings::size);
    FalseClaim.unless(
        claims.numbers(SIZES).filter(said -> Arrays.equals(said, sizes)).isPresent(),
        "the field \"" + SIZES + "\" is not " + Arrays.toString(sizes));
    FalseClaim.unless(
        claims.has(RINGS) && claims.has(FIXED), "the rings or the fixed edges are missing");
    FalseClaim.unless(
        2 * rings.fixedCount() == claims.pairs(FIXED).orElseThrow().length,
        "the field \"" + FIXED + "\" names an edge of a ring, or an edge twice");
  }
}
