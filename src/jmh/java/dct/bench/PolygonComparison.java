package dct.bench;

import dct.bench.Contest.Outcome;
import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.MonotoneTriangulation;
import dct.experiment.generate.PolygonShape;
import dct.io.PointFile;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Triangulations of simple polygons: ours and those of the peers. Our monotone triangulation is
 * timed without and with the exact check that the polygon is simple, which no peer makes.
 */
final class PolygonComparison {
  private static final List<PolygonShape> SHAPES =
      List.of(
          PolygonShape.STAR_SHAPED,
          PolygonShape.COMB,
          PolygonShape.SPIRAL,
          PolygonShape.TOUR,
          PolygonShape.ORTHOGONAL,
          PolygonShape.SPANNING_TREE);
  private static final int SMALLEST = 100;
  private static final int PROBED = 100_000; // so many vertices may keep a peer from coming back
  private static final int OURS = 3; // the first contenders
  private static final long SEED = 1;

  private final PrintStream out;
  private final int largest;
  private final List<Path> files;

  PolygonComparison(PrintStream out, int largest, List<Path> files) {
    this.out = out;
    this.largest = largest;
    this.files = files;
  }

  /** Ours take the polygon as it is after the check, so that the work compared is the same. */
  private static List<Contender> contenders(SimplePolygon polygon) {
    return List.of(
        new Contender(
            "dct monotone",
            (x, y) -> MonotoneTriangulation.triangulate(polygon, Progress.NONE).triangles()),
        new Contender(
            "dct ear clipping",
            (x, y) -> EarClipping.triangulate(polygon, Progress.NONE).triangles()),
        new Contender("dct monotone, checked", PolygonComparison::checked),
        new Contender("earcut4j", EarcutPeer::polygon),
        new Contender("JTS", JtsPeer::polygon),
        new Contender("poly2tri", Poly2TriPeer::polygon),
        new Contender("GLU (JOGL)", GluPeer::polygon),
        new Contender("Tinfour", TinfourPeer::polygon));
  }

  private static int[] checked(double[] x, double[] y) {
    SimplePolygon polygon = SimplePolygon.of(Points.of(x, y), Progress.NONE);
    return MonotoneTriangulation.triangulate(polygon, Progress.NONE).triangles();
  }

  void run() {
    out.println("\n## Triangulating a simple polygon\n");
    out.println(
        "From an array of doubles to an array of n − 2 triangles, the polygon known to be simple."
            + " Medians of wall times in milliseconds; in brackets the time of dct's monotone"
            + " triangulation over theirs, round by round.\n");
    SimplePolygon triangle = PolygonShape.CONVEX.generate(3, 1);
    ComparisonTable table = new ComparisonTable(out, contenders(triangle));
    table.head("polygon");
    for (PolygonShape shape : SHAPES) {
      Pace pace = new Pace(contenders(triangle).size());
      for (int n = SMALLEST; n <= largest; n *= 10) {
        Outcome[] outcomes = contest(shape.generate(n, SEED), sittingOut(shape, n, pace));
        table.row("%s %,d".formatted(shape.title(), n), outcomes);
        pace.note(outcomes);
      }
    }
    for (Path file : files) {
      SimplePolygon polygon =
          SimplePolygon.of(walked(PointFile.read(file, Progress.NONE).points()), Progress.NONE);
      String name = String.valueOf(file.getFileName()).replace(".txt", "");
      String[] all = new String[contenders(polygon).size()];
      table.row("%s %,d".formatted(name, polygon.size()), contest(polygon, all));
    }
  }

  private static String[] sittingOut(PolygonShape shape, int n, Pace pace) {
    String[] remarks = pace.sittingOut();
    for (int c = OURS; n >= PROBED && c < remarks.length; c++) {
      remarks[c] = remarks[c] == null ? Probe.remark(shape, n, c) : remarks[c];
    }
    return remarks;
  }

  /** What is wrong with the result of one contender on a polygon of this shape, if anything. */
  static Optional<String> problem(PolygonShape shape, int n, int contender) throws Exception {
    SimplePolygon polygon = shape.generate(n, SEED);
    double[] x = polygon.points().xs();
    double[] y = polygon.points().ys();
    return TriangleCheck.ofPolygon(
        x, y, contenders(polygon).get(contender).maker().triangles(x, y));
  }

  /** The vertices counter-clockwise, as some peers want them. */
  private static Points walked(Points points) {
    int[] walk = SimplePolygon.of(points, Progress.NONE).walk();
    return Points.of(
        Arrays.stream(walk).mapToDouble(points::x).toArray(),
        Arrays.stream(walk).mapToDouble(points::y).toArray());
  }

  private static Outcome[] contest(SimplePolygon polygon, String[] sittingOut) {
    Points points = polygon.points();
    return Contest.hold(
        points.xs(),
        points.ys(),
        contenders(polygon),
        (x, y, contender, triangles) -> TriangleCheck.ofPolygon(x, y, triangles),
        sittingOut);
  }
}
