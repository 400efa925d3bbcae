package dct.core.degree.best;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.region.MeshExport;
import dct.core.degree.region.PartSearch;
import dct.core.degree.region.SearchMesh;
import dct.core.degree.strip.StripSearch;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import java.util.function.Consumer;
import java.util.stream.IntStream;

/**
 * Few unmet vertices in a triangulation of sites or of a region, found by re-solving one part of it
 * after the other; their number never grows.
 *
 * <p>{@link #pairUp}: a small region, a simple polygon with no vertex inside, is cut out and
 * triangulated anew by an exact table, the parities outside it being given. First a region around
 * each unmet vertex is solved in spatial order, three times; then the vertices that are left are
 * walked towards each other until they meet and vanish ({@link PartSearch}). Many sites are
 * searched in parts, unbroken stretches of a Hilbert curve, on all cores; the parts depend on the
 * number of sites alone and each has random choices of its own, so that the result does not depend
 * on threads. The parts are then moved by half their length, and what is left is paired over the
 * whole.
 *
 * <p>{@link #solveStrips}: for what that leaves, in regular patterns and on long straight sides of
 * the hull, larger parts with vertices inside, up to whole strips along a side, are solved anew by
 * a beam search ({@link StripSearch}).
 *
 * <p>Each step costs the same however many sites there are; on random sites about O(n) steps are
 * taken. Space O(n). Ends early, with what it has, when the progress asks to stop.
 */
final class SiteSearch {
  private static final int WEIGHT = 1 << 20; // of an unmet vertex, against pull and noise
  private static final int PART = 1 << 13; // vertices of a part
  private static final int SWEEPS = 3;
  private static final int PART_PATIENCE = 3; // rounds that have not helped

  private final Triangulation start;
  private final long seed;
  private final Progress progress;
  private final SearchMesh mesh;
  private int passes;
  private StripSearch strips; // null until it is begun

  /**
   * A search from a triangulation of sites with at least one triangle.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  SiteSearch(Triangulation start, ParityGoal goal, long seed, Progress progress) {
    this.start = start;
    this.seed = seed;
    this.progress = progress;
    mesh = new SearchMesh(start, goal, WEIGHT, progress);
  }

  /**
   * Turns the diagonals of rectangles the same way, whatever that does to the wishes.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  void alignRectangles() {
    RectangleDiagonals.align(mesh, progress);
  }

  /** How many vertices are unmet, in linear time. */
  int unmet() {
    return mesh.unmet();
  }

  /** The triangulation as it is now. */
  Triangulation triangulation() {
    return MeshExport.triangulation(mesh, start);
  }

  /**
   * Sweeps and pairs until no more than {@code enough} are unmet or {@code patience} rounds on end
   * have not helped.
   */
  void pairUp(int enough, int patience) {
    if (mesh.size() > 2 * PART) {
      searchInParts();
    }
    SeededRandom random = SeededRandom.of(seed, passes, 0);
    PartSearch whole = new PartSearch(mesh, random, progress, 0, mesh.size());
    for (int pass = passes; pass < SWEEPS; pass++) {
      whole.sweep(enough);
    }
    report(0.8, whole.unmet());
    whole.pairUp(enough, patience);
  }

  /**
   * Solves strips until no more than {@code enough} are unmet or the effort is spent; asked again,
   * goes on. The last stage.
   */
  void solveStrips(int enough, double effort) {
    strips = strips == null ? new StripSearch(mesh, progress, seed) : strips;
    strips.run(enough, effort);
  }

  private void searchInParts() {
    for (int pass = 0; pass < SWEEPS && !progress.isCancelled(); pass++) {
      inParts(part -> part.sweep(0));
    }
    int pairings =
        start.domain() == Domain.SITES ? 2 : 0; // distances are those of the whole region
    for (int pass = 0; pass < pairings && !progress.isCancelled(); pass++) {
      inParts(part -> part.pairUp(0, PART_PATIENCE));
    }
  }

  /** One pass over all parts at the same time; every other pass moves them by half their length. */
  private void inParts(Consumer<PartSearch> task) {
    int shift = (passes & 1) * (PART / 2);
    int parts = (mesh.size() + shift + PART - 1) / PART;
    IntStream.range(0, parts)
        .parallel()
        .filter(p -> !progress.isCancelled())
        .forEach(p -> task.accept(part(p, p * PART - shift)));
    passes++;
    report(0.15 * passes, mesh.unmet());
  }

  private PartSearch part(int index, int from) {
    int lo = Math.max(0, from);
    int hi = Math.min(mesh.size(), from + PART);
    return new PartSearch(mesh, SeededRandom.of(seed, passes, index), progress, lo, hi);
  }

  private void report(double fraction, int unmet) {
    progress.report(fraction, Optimum.soFar(unmet));
  }
}
