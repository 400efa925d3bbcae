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
import java.util.List;
import java.util.Locale;

/**
 * Constrained Delaunay triangulations of polygons and of regions with holes, sites and fixed edges,
 * beside the Delaunay triangulation of the same vertices, with which they start. Arguments: the
 * numbers of vertices.
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

  private RegionTable(PrintStream out) {
    this.out = out;
  }

  public static void main(String[] args) {
    Locale.setDefault(Locale.ROOT);
    RegionTable table = new RegionTable(new PrintStream(System.out, true, StandardCharsets.UTF_8));
    table.out.println("| region | vertices | missing edges | Delaunay | constrained | ratio |");
    table.out.println("|---|---:|---:|---:|---:|---:|");
    for (String n : args.length == 0 ? new String[] {"100000", "1000000"} : args) {
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
    double[] plain = new double[ROUNDS];
    double[] constrained = new double[ROUNDS];
    double[] ratio = new double[ROUNDS];
    for (int k = -WARM_UP; k < ROUNDS; k++) {
      double ours = millis(() -> ConstrainedDelaunay.triangulate(region, Progress.NONE));
      double delaunay = millis(() -> Delaunay.triangulate(sites, Progress.NONE));
      if (k >= 0) {
        plain[k] = delaunay;
        constrained[k] = ours;
        ratio[k] = ours / delaunay;
      }
    }
    out.printf(
        "| %s | %,d | %,d | %s | %s | %.1f |%n",
        name,
        region.size(),
        missing(region, Delaunay.triangulate(sites, Progress.NONE)),
        ComparisonTable.millis(Contest.median(plain)),
        ComparisonTable.millis(Contest.median(constrained)),
        Contest.median(ratio));
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
