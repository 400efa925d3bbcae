package dct.bench;

import dct.bench.Contest.Outcome;
import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import java.io.PrintStream;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** Delaunay triangulations: ours and those of the peers, on one distribution after the other. */
final class SiteComparison {
  private static final List<Contender> CONTENDERS =
      List.of(
          new Contender("dct", SiteComparison::ours),
          new Contender("Tinfour", TinfourPeer::sites),
          new Contender("JTS", JtsPeer::sites),
          new Contender("Tektosyne", TektosynePeer::sites));
  private static final int EDGES_ONLY = 3; // the contender that gives edges, not triangles

  private final PrintStream out;
  private final int largest;

  SiteComparison(PrintStream out, int largest) {
    this.out = out;
    this.largest = largest;
  }

  private static int[] ours(double[] x, double[] y) {
    return Delaunay.triangulate(Sites.of(Points.of(x, y), Progress.NONE), Progress.NONE)
        .triangles();
  }

  void run() {
    out.println("## Delaunay triangulation\n");
    out.println(
        "From an array of doubles to an array of triangles (Tektosyne: of edges). Medians of wall"
            + " times in milliseconds; in brackets our time over theirs, round by round.\n");
    ComparisonTable table = new ComparisonTable(out, CONTENDERS);
    table.head("sites");
    for (SiteFamily family : SiteFamily.all()) {
      if (!family.isNasty()) {
        Pace pace = new Pace(CONTENDERS.size());
        for (int n = 1000; n <= largest; n *= 10) {
          Outcome[] outcomes = contest(family.make(n), pace.sittingOut());
          table.row("%s %,d".formatted(family.title(), n), outcomes);
          pace.note(outcomes);
        }
      }
    }
    nasty(table);
  }

  private void nasty(ComparisonTable table) {
    out.println("\n### Sets that break floating point\n");
    table.head("sites");
    for (SiteFamily family : SiteFamily.all()) {
      if (family.isNasty()) {
        double[][] points = family.make(0);
        String name = "%s %,d".formatted(family.title(), points[0].length);
        String[] remarks = new String[CONTENDERS.size()];
        Arrays.setAll(remarks, c -> Probe.remark(family, c));
        table.row(name, contest(points, remarks));
      }
    }
  }

  /** What is wrong with the result of one contender on these points, if anything. */
  static Optional<String> problem(double[][] points, int contender) throws Exception {
    int[] result = CONTENDERS.get(contender).maker().triangles(points[0], points[1]);
    return problem(points[0], points[1], contender, result);
  }

  private static Outcome[] contest(double[][] points, String[] sittingOut) {
    return Contest.hold(points[0], points[1], CONTENDERS, SiteComparison::problem, sittingOut);
  }

  private static Optional<String> problem(double[] x, double[] y, int contender, int[] result) {
    Sites sites = Sites.of(Points.of(x, y), Progress.NONE);
    boolean isLine = HullCount.of(sites.points().xs(), sites.points().ys()) == 2 * (x.length - 1);
    if (isLine) {
      int found = contender == EDGES_ONLY ? 0 : result.length;
      return found == 0 ? Optional.empty() : Optional.of("triangles on a line");
    }
    int[] triangles = contender == EDGES_ONLY ? EdgeTriangles.of(x, y, result) : result;
    return TriangleCheck.ofSites(
        sites.points().xs(), sites.points().ys(), renumbered(sites, x, y, triangles));
  }

  /** Corners that were merged into an equal site before them carry another number in each. */
  private static int[] renumbered(Sites sites, double[] x, double[] y, int[] triangles) {
    if (sites.merged() == 0 || triangles.length == 0) {
      return triangles;
    }
    int most = Arrays.stream(triangles).max().orElseThrow();
    if (most < sites.size()) {
      return triangles; // as ours are, and there the check has the last word
    }
    int[] order = IntStream.range(0, x.length).toArray();
    SiteNumbers numbers = new SiteNumbers(sites.points());
    int[] number = Arrays.stream(order).map(i -> numbers.of(x[i], y[i])).toArray();
    return Arrays.stream(triangles).map(v -> number[v]).toArray();
  }
}
