package dct.bench;

import dct.core.Progress;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import dct.core.geometry.Sites;
import dct.core.triangulate.ConstrainedDelaunay;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.PolygonShape;
import dct.testing.RandomRegions;
import dct.testing.RandomSets;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Constrained Delaunay triangulations of polygons and of regions with holes, sites and fixed edges,
 * beside the Delaunay triangulation of the same vertices, with which they start, and beside {@link
 * CgalProcess} if its program is the first argument. The others: the numbers of vertices.
 */
public final class RegionTable {
  private static final List<PolygonShape> SHAPES =
      List.of(
          PolygonShape.TOUR,
          PolygonShape.ORTHOGONAL,
          PolygonShape.SPIRAL,
          PolygonShape.STAR_SHAPED,
          PolygonShape.COMB);
  private static final long SEED = 1;
  private static final int PER_HOLE = 1000;
  private static final int FIXED = 10; // of 100 edges
  private static final int STRETCHED = 8;
  private static final int WARM_UP = 3;
  private static final int ROUNDS = 9;

  private final PrintStream out;
  private final Optional<String> cgal;

  private RegionTable(PrintStream out, Optional<String> cgal) {
    this.out = out;
    this.cgal = cgal;
  }

  public static void main(String[] args) {
    Locale.setDefault(Locale.ROOT);
    Optional<String> cgal =
        Arrays.stream(args).limit(1).filter(first -> !first.matches("[0-9]+")).findFirst();
    List<String> sizes = Arrays.stream(args).skip(cgal.isPresent() ? 1 : 0).toList();
    PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    RegionTable table = new RegionTable(out, cgal);
    table.out.println("| region | vertices | missing edges | Delaunay | constrained | CGAL |");
    table.out.println("|---|---:|---:|---:|---:|---:|");
    for (String n : sizes.isEmpty() ? List.of("100000", "1000000") : sizes) {
      table.rows(Integer.parseInt(n));
    }
  }

  private void rows(int n) {
    for (PolygonShape shape : SHAPES) {
      row(shape.title(), Region.of(shape.generate(n, SEED)));
    }
    Rings rings = RandomRegions.make(RandomSets.families().get(0), n, n / PER_HOLE, FIXED, SEED);
    row("holes, sites, fixed edges", Region.of(rings, Progress.NONE));
    Rings stretched = RandomRegions.stretched(rings, STRETCHED);
    row("the same, stretched", Region.of(stretched, Progress.NONE));
  }

  private void row(String name, Region region) {
    Sites sites = Sites.of(region.points(), Progress.NONE);
    Triangulation delaunay = Delaunay.triangulate(sites, Progress.NONE);
    double[] plain = new double[ROUNDS];
    double[] constrained = new double[ROUNDS];
    double[] peer = new double[ROUNDS];
    double[] ratio = new double[ROUNDS];
    try (CgalProcess process = CgalProcess.of(cgal, region, delaunay.triangleCount())) {
      for (int k = -WARM_UP; k < ROUNDS; k++) {
        double ours = millis(() -> ConstrainedDelaunay.triangulate(region, Progress.NONE));
        double start = millis(() -> Delaunay.triangulate(sites, Progress.NONE));
        double theirs = process.millis();
        if (k >= 0) {
          plain[k] = start;
          constrained[k] = ours;
          peer[k] = theirs;
          ratio[k] = ours / theirs;
        }
      }
    }
    String theirs = ComparisonTable.millis(Contest.median(peer));
    out.printf(
        "| %s | %,d | %,d | %s | **%s** | %s |%n",
        name,
        region.size(),
        missing(region, delaunay),
        ComparisonTable.millis(Contest.median(plain)),
        ComparisonTable.millis(Contest.median(constrained)),
        cgal.isEmpty() ? "–" : theirs + String.format(" (%.2f)", Contest.median(ratio)));
  }

  private static double millis(Runnable run) {
    System.gc();
    long start = System.nanoTime();
    run.run();
    return (System.nanoTime() - start) * 1e-6;
  }

  /** How many edges of rings and fixed edges are not Delaunay. */
  private static int missing(Region region, Triangulation delaunay) {
    Rings rings = region.rings();
    int count = 0;
    for (int edge = 0; edge < region.size() + rings.fixedCount(); edge++) {
      boolean used = edge >= region.size() || rings.isOnRing(edge);
      if (used && delaunay.edgeBetween(rings.from(edge), rings.to(edge)).isEmpty()) {
        count++;
      }
    }
    return count;
  }
}
