package dct.core.degree.bound;

import dct.core.Progress;
import dct.core.degree.colour.HullRing;
import dct.core.degree.colour.OddSites;
import java.util.BitSet;
import java.util.Optional;

/**
 * The empty triangles of which windows consist: all, or as many as are allowed, at the sites that a
 * sweep meets next.
 */
final class WindowSites {
  static final int MOST_TRIANGLES = 150_000; // of one region
  private static final int FEWEST = 8; // sites of a region
  private static final int MOST_REGIONS = 24;

  private final HullRing ring;
  private final Progress progress;
  private final Optional<OddSites> whole;
  private int regions; // so far

  /** Some sites at which all empty triangles are known, up to this place of a sweep. */
  record Region(OddSites sites, int end) {}

  WindowSites(HullRing ring, Progress progress) {
    this.ring = ring;
    this.progress = progress;
    BitSet all = new BitSet();
    all.set(0, ring.points().size());
    whole = OddSites.of(ring, all, MOST_TRIANGLES, progress);
  }

  boolean isWhole() {
    return whole.isPresent();
  }

  /** All sites, if they have few enough triangles. */
  OddSites whole() {
    return whole.orElseThrow();
  }

  /** The sites in an order from some place on; it ends there if there are too many triangles. */
  Region from(int[] order, int from) {
    if (isWhole()) {
      return new Region(whole(), order.length);
    }
    Region best = new Region(null, from);
    boolean goesOn = regions++ < MOST_REGIONS && fits(FEWEST);
    for (int length = FEWEST; goesOn; length *= 2) {
      int end = Math.min(order.length, from + length);
      Optional<OddSites> sites =
          OddSites.of(ring, sites(order, from, end), MOST_TRIANGLES, progress);
      best = sites.isPresent() ? new Region(sites.get(), end) : best;
      goesOn = sites.isPresent() && end < order.length;
    }
    return best;
  }

  /** A site of random ones has several triangles with every site that it sees. */
  private boolean fits(int sites) {
    return (long) sites * ring.points().size() <= MOST_TRIANGLES;
  }

  /** The sites from one place of an order to before another. */
  static BitSet sites(int[] order, int from, int end) {
    BitSet sites = new BitSet();
    for (int i = from; i < end; i++) {
      sites.set(order[i]);
    }
    return sites;
  }
}
