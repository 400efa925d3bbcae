package dct.core.degree.region;

import dct.core.Progress;
import dct.core.SeededRandom;

/**
 * Grants the wishes of vertices in one part of a {@link SearchMesh}: those numbered from {@code lo}
 * to {@code hi} − 1, an unbroken stretch of the Hilbert curve. Triangles with a corner elsewhere
 * stay, so that parts can be searched at the same time.
 *
 * <p>{@link #sweep} re-solves a region around each unmet vertex. {@link #pairUp} walks each vertex
 * that is left towards another one, or towards one of which nothing is wished, until the two meet
 * and vanish. Neither ever makes the number of unmet vertices larger. A step costs the same
 * whatever the size of the part.
 *
 * <p>In a region the way to a partner leads round holes: distances are counted in edges of the mesh
 * ({@link Hops}), and only a search of the whole region may walk. What is solved anew has more
 * vertices there, since many of its edges are on the boundary.
 *
 * <p>Two that meet need not vanish: around them the triangles may force a three-colouring of the
 * vertices to turn by a third, which a region without unmet vertices cannot do. Then another
 * partner, or the same one reached by another way, will do; so partners are drawn more freely the
 * longer nothing helps.
 */
public final class PartSearch {
  private static final int SIZE = 10; // vertices of a region
  private static final int TRIES = 3; // to grow by one vertex
  private static final int REGION_TRIES = 8; // the same where many edges are on the boundary
  private static final int REGION_SIZE = 28; // vertices of a region there
  private static final int CHECK_EVERY = 32; // steps between two looks at the progress
  private static final int NEIGHBOURS = 8; // looked at on each side along the curve for a partner
  private static final int DETOUR = 64; // how far along the curve a vertex is led astray
  private static final int PATIENCE = 6; // steps of one walk that come no nearer
  private static final int SWEEP_NOISE_BITS = 10;
  private static final int PULL_BITS = 14;
  private static final int NOISE_BITS = 9;
  private static final int STUCK = 4; // rounds without help, after which walks are varied
  private static final int LARGEST = 32; // vertices of a region then

  private final SearchMesh mesh;
  private final SeededRandom random;
  private final Progress progress;
  private final int lo;
  private final int hi;
  private final MeshRegion region;
  private final int tries; // to grow by one vertex
  private final VertexList open = new VertexList(); // unmet at the start of a round, in order
  private final VertexList seen = new VertexList(); // perhaps unmet at its end
  private int unmet;
  private int steps;
  private final int usualSize;
  private int size; // of the regions of a walk
  private int pullBits = PULL_BITS;
  private int noiseBits = NOISE_BITS;
  private int first; // the unmet vertex of the region nearest to the target, or NONE
  private int second; // the one after it, or NONE

  public PartSearch(SearchMesh mesh, SeededRandom random, Progress progress, int lo, int hi) {
    this.mesh = mesh;
    this.random = random;
    this.progress = progress;
    this.lo = lo;
    this.hi = hi;
    region = new MeshRegion(mesh, random, progress, LARGEST, lo, hi);
    tries = mesh.hops == null ? TRIES : REGION_TRIES;
    usualSize = mesh.hops == null ? SIZE : REGION_SIZE;
    size = usualSize;
    collect();
  }

  private void collect() {
    open.clear();
    for (int v = lo; v < hi; v++) {
      if (mesh.isUnmet(v)) {
        open.add(v);
      }
    }
    unmet = open.size();
  }

  /** How many vertices of the part are unmet. */
  public int unmet() {
    return unmet;
  }

  /**
   * Re-solves a region around each vertex that is unmet when its turn comes, as long as more than
   * {@code enough} are.
   */
  public void sweep(int enough) {
    for (int v = lo; v < hi && unmet > enough && !isOver(); v++) {
      if (mesh.isUnmet(v) && region.open(mesh.halfEdgeAt(v, random))) {
        region.grow(usualSize, tries);
        unmet += region.fill(SWEEP_NOISE_BITS);
      }
    }
  }

  private boolean isOver() {
    return ++steps % CHECK_EVERY == 0 && progress.isCancelled();
  }

  /**
   * Walks unmet vertices towards each other, round by round, until no more than {@code enough} are
   * left or {@code patience} rounds in a row have not helped.
   */
  public void pairUp(int enough, int patience) {
    collect();
    int idle = 0;
    while (unmet > enough && idle < patience && !progress.isCancelled()) {
      int before = unmet;
      round(enough, idle);
      idle = unmet < before ? 0 : idle + 1;
    }
  }

  private void round(int enough, int idle) {
    seen.clear();
    for (int q = 0; q < open.size() && unmet > enough && !isOver(); q++) {
      int v = open.get(q);
      int partner = mesh.isUnmet(v) ? target(q, idle) : SearchMesh.NONE;
      if (partner != SearchMesh.NONE) {
        vary(idle);
        walk(v, partner);
      }
    }
    seen.addAll(open);
    open.setSome(seen, mesh::isUnmet);
  }

  /** Larger regions, a weaker pull and more noise where the usual ones have not helped. */
  private void vary(int idle) {
    boolean usual = idle < STUCK || random.nextInt(4) == 0;
    size = usual ? usualSize : SIZE + random.nextInt(random.nextInt(LARGEST - SIZE) + 1);
    pullBits = usual ? PULL_BITS : PULL_BITS - random.nextInt(7);
    noiseBits = usual ? NOISE_BITS : NOISE_BITS + 3;
  }

  private int target(int q, int idle) {
    if (mesh.hops == null) {
      return partner(q, idle);
    }
    int v = open.get(q);
    int choice = idle == 0 ? 0 : random.nextInt(6);
    int partner =
        switch (choice) {
          case 1, 2 -> random.nextInt(mesh.size()); // any vertex, to come back by another way
          case 3 -> anyPartner(q);
          default -> mesh.hops.search(v, u -> mesh.isUnmet(u) || mesh.weight[u] == 0);
        };
    return partner == SearchMesh.NONE ? partner : reachable(partner, v);
  }

  /** Measures the distances to a vertex; NONE if another one cannot be reached from there. */
  private int reachable(int partner, int v) {
    return mesh.hops.search(partner, u -> u == v) == v ? partner : SearchMesh.NONE;
  }

  /** A vertex to meet: the nearest, or, where that has not helped, now and then another. */
  private int partner(int q, int idle) {
    int choice = idle == 0 ? 0 : random.nextInt(6);
    return switch (choice) {
      case 1, 2 -> astray(open.get(q));
      case 3 -> anyPartner(q);
      default -> nearestPartner(q, idle > 0);
    };
  }

  /** Any vertex not far off, to come back from there by another way. */
  private int astray(int v) {
    return Math.max(lo, Math.min(hi - 1, v + random.nextInt(2 * DETOUR) - DETOUR));
  }

  private int anyPartner(int q) {
    int u = open.get(random.nextInt(open.size()));
    return u != open.get(q) && mesh.isUnmet(u) ? u : SearchMesh.NONE;
  }

  private int nearestPartner(int q, boolean roughly) {
    int v = open.get(q);
    int nearest = mesh.freeVertexNear(v, lo, hi);
    double least =
        nearest == SearchMesh.NONE ? Double.POSITIVE_INFINITY : mesh.squaredDistance(nearest, v);
    int last = Math.min(open.size() - 1, q + NEIGHBOURS);
    for (int i = Math.max(0, q - NEIGHBOURS); i <= last; i++) {
      int u = open.get(i);
      if (u != v && mesh.isUnmet(u)) {
        double factor = roughly ? 0.1 + random.nextDouble() : 1;
        double distance = factor * mesh.squaredDistance(u, v);
        if (distance < least) {
          least = distance;
          nearest = u;
        }
      }
    }
    return nearest;
  }

  /** Moves an unmet vertex towards a target, until some vanish or it comes no nearer. */
  private void walk(int from, int to) {
    int v = from;
    int target = to;
    double distance = mesh.away(v, target);
    int idle = 0;
    while (idle < PATIENCE && !isOver()) {
      int change = step(v, target);
      boolean hasMet = region.contains(target);
      if (change < 0 || first == SearchMesh.NONE || (hasMet && second == SearchMesh.NONE)) {
        return;
      }
      if (hasMet && mesh.hops != null) {
        return;
      }
      v = hasMet ? second : first;
      target = hasMet ? first : target;
      double left = mesh.away(v, target);
      idle = left < distance ? idle : idle + 1;
      distance = left;
    }
  }

  /** Re-solves a region that reaches from v towards a target. */
  private int step(int v, int target) {
    int change = 0;
    if (region.open(mesh.halfEdgeAt(v, random))) {
      region.growTowards(target, size, tries);
      change = region.fillTowards(target, 1 << pullBits, noiseBits);
      unmet += change;
    }
    rank(target);
    return change;
  }

  /** Finds the two unmet vertices of the region nearest to the target, and notes them all. */
  private void rank(int target) {
    first = SearchMesh.NONE;
    second = SearchMesh.NONE;
    for (int i = 0; i < region.size(); i++) {
      int w = region.vertex(i);
      if (mesh.isUnmet(w)) {
        seen.add(w);
        if (isNearer(w, first, target)) {
          second = first;
          first = w;
        } else if (isNearer(w, second, target)) {
          second = w;
        }
      }
    }
  }

  private boolean isNearer(int u, int v, int target) {
    return v == SearchMesh.NONE || mesh.away(u, target) < mesh.away(v, target);
  }
}
