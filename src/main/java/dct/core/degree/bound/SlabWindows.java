package dct.core.degree.bound;

import dct.core.degree.LocalBound;
import dct.core.degree.colour.OddSites;
import java.util.ArrayList;
import java.util.List;

/**
 * Windows between parallel lines: runs of sites in the order of a sweep. Each time the shortest run
 * of which one site misses its wish; then neighbours are joined where together, and with what is
 * between them, they have more unmet sites than each for itself.
 */
final class SlabWindows {
  private static final int SHORTEST = 6; // sites of the first window tried

  private final WindowProof proof;
  private final WindowSites regions;
  private final int[] order;
  private final int enough;
  private final List<Run> runs = new ArrayList<>();

  /** Sites order[from] … order[end − 1], of which so many are unmet. */
  private record Run(int from, int end, int unmet) {}

  private SlabWindows(WindowProof proof, WindowSites regions, int[] order, int enough) {
    this.proof = proof;
    this.regions = regions;
    this.order = order;
    this.enough = enough;
  }

  /**
   * The windows found.
   *
   * @param order the sites by their distance from a line, those of one distance along it
   * @param enough stop at a sum of so many unmet sites
   */
  static List<LocalBound> find(WindowProof proof, WindowSites regions, int[] order, int enough) {
    SlabWindows slabs = new SlabWindows(proof, regions, order, enough);
    slabs.sweep();
    if (regions.isWhole()) {
      slabs.join();
    }
    return slabs.runs.stream().map(slabs::window).toList();
  }

  private LocalBound window(Run run) {
    return new LocalBound(WindowSites.sites(order, run.from, run.end), run.unmet);
  }

  private boolean holds(OddSites region, int from, int end, int unmet) {
    return proof.holds(region, window(new Run(from, end, unmet)));
  }

  private int sum() {
    return runs.stream().mapToInt(Run::unmet).sum();
  }

  private void sweep() {
    int from = 0;
    while (from < order.length && sum() < enough && !proof.isSpent()) {
      WindowSites.Region region = regions.from(order, from);
      if (region.end() == from) {
        return;
      }
      int end = shortest(region, from);
      if (end > from) {
        runs.add(new Run(from, end, 1));
      }
      from = end > from ? end : region.end();
    }
  }

  /** The end of the shortest window found that begins there, or −1. */
  private int shortest(WindowSites.Region region, int from) {
    int held = from; // the longest known not to be refuted ends there
    int length = SHORTEST;
    int end = Math.min(region.end(), from + length);
    while (!holds(region.sites(), from, end, 1)) {
      if (end == region.end() || proof.isSpent()) {
        return -1;
      }
      held = end;
      length += length / 2;
      end = Math.min(region.end(), from + length);
    }
    while (end - held > 1) {
      int middle = (held + end) >>> 1;
      if (holds(region.sites(), from, middle, 1)) {
        end = middle;
      } else {
        held = middle;
      }
    }
    return end;
  }

  private void join() {
    int i = 0;
    while (i + 1 < runs.size() && sum() < enough && !proof.isSpent()) {
      int from = i == 0 ? 0 : runs.get(i).from;
      int end = i + 2 == runs.size() ? order.length : runs.get(i + 1).end;
      Run both = new Run(from, end, runs.get(i).unmet + runs.get(i + 1).unmet + 1);
      if (proof.holds(regions.whole(), window(both))) {
        runs.set(i, both);
        runs.remove(i + 1);
        i = Math.max(0, i - 1);
      } else {
        i++;
      }
    }
  }
}
