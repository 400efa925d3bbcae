package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.ConstrainedDelaunay;
import dct.core.triangulate.Triangulation;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Chains inside one another, for regions with holes.
 *
 * <p>An annulus is a star-shaped ring whose vertices are at least half its radius away from its
 * centre, and in the disk that lies inside all its edges a polygon of another family. Other holes
 * are put into the largest circles inscribed in triangles of the constrained Delaunay triangulation
 * of the outer polygon, one a triangle, so that none meets another.
 */
final class Nested {
  private static final double ROOM = 0.9; // of a disk that a hole may fill

  private Nested() {}

  /** A circle. */
  private record Disk(double x, double y, double radius) {}

  /** A ring of so many vertices, and one inside. */
  static List<Points> annulus(int outer, int inner, SeededRandom random, Progress progress) {
    double radius = Math.min(Area.CANVAS.width(), Area.CANVAS.height()) / 2.0;
    Disk whole = new Disk(Area.CANVAS.width() / 2.0, Area.CANVAS.height() / 2.0, radius);
    Points ring = star(outer, whole, random);
    Disk inside = new Disk(whole.x, whole.y, distance(ring, whole));
    Points hole =
        PolygonShape.TWO_OPT
            .generate(inner, Area.CANVAS.real(), random.nextLong(), progress)
            .points();
    return List.of(ring, into(inside, hole));
  }

  /** The distance from the centre to the nearest edge. */
  private static double distance(Points ring, Disk disk) {
    double least = Double.POSITIVE_INFINITY;
    for (int v = 0; v < ring.size(); v++) {
      int w = v + 1 == ring.size() ? 0 : v + 1;
      double dx = ring.x(w) - ring.x(v);
      double dy = ring.y(w) - ring.y(v);
      double area = (disk.x - ring.x(v)) * dy - (disk.y - ring.y(v)) * dx;
      least = Math.min(least, Math.abs(area) / Math.sqrt(dx * dx + dy * dy));
    }
    return least;
  }

  /** The points of the canvas, scaled into a disk. */
  private static Points into(Disk disk, Points points) {
    double width = Area.CANVAS.width();
    double height = Area.CANVAS.height();
    double scale = ROOM * 2 * disk.radius / Math.sqrt(width * width + height * height);
    double[] x = points.xs();
    double[] y = points.ys();
    for (int v = 0; v < x.length; v++) {
      x[v] = disk.x + scale * (x[v] - width / 2);
      y[v] = disk.y + scale * (y[v] - height / 2);
    }
    return Points.of(x, y);
  }

  /** A star-shaped ring between half a disk's radius and the whole; its centre sees all of it. */
  private static Points star(int n, Disk disk, SeededRandom random) {
    double[] x = new double[n];
    double[] y = new double[n];
    for (int k = 0; k < n; k++) {
      double turn =
          2 * Math.PI * (k + 0.3 * random.nextDouble()) / n; // three never half a turn apart
      double radius = disk.radius * (0.5 + 0.5 * random.nextDouble());
      x[k] = disk.x + radius * StrictMath.cos(turn);
      y[k] = disk.y + radius * StrictMath.sin(turn);
    }
    return Points.of(x, y);
  }

  /**
   * A polygon of a family with holes.
   *
   * @param rectangles whether holes are rectangles, and not star-shaped
   * @param sizes the number of vertices of the polygon and of each hole
   * @throws CannotGenerateException if the polygon has fewer triangles than there are to be holes
   */
  static List<Points> holes(
      PolygonShape outer, boolean rectangles, int[] sizes, SeededRandom random, Progress progress) {
    int n = sizes[0];
    SimplePolygon polygon = outer.generate(n, outer.areaFor(n), random.nextLong(), progress);
    List<Disk> disks = largestDisks(polygon, progress);
    if (disks.size() < sizes.length - 1) {
      throw new CannotGenerateException(
          "a polygon of "
              + n
              + " vertices has no room for so many holes; take fewer or more vertices");
    }
    List<Points> chains = new ArrayList<>();
    chains.add(polygon.points());
    for (int h = 1; h < sizes.length; h++) {
      Disk disk = disks.get(h - 1);
      Disk room = new Disk(disk.x, disk.y, ROOM * disk.radius);
      chains.add(rectangles ? rectangle(room, random) : star(sizes[h], room, random));
    }
    return chains;
  }

  private static Points rectangle(Disk disk, SeededRandom random) {
    double turn = (0.15 + 0.2 * random.nextDouble()) * Math.PI; // of the diagonal
    double a = disk.radius * StrictMath.cos(turn);
    double b = disk.radius * StrictMath.sin(turn);
    return Points.ofPairs(
        disk.x - a,
        disk.y - b,
        disk.x + a,
        disk.y - b,
        disk.x + a,
        disk.y + b,
        disk.x - a,
        disk.y + b);
  }

  /** The inscribed circles of the triangles, the largest first. */
  private static List<Disk> largestDisks(SimplePolygon polygon, Progress progress) {
    Triangulation made = ConstrainedDelaunay.triangulate(Region.of(polygon), progress);
    int[] corners = made.triangles();
    return IntStream.range(0, corners.length / 3)
        .mapToObj(
            t -> inscribed(made.points(), corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]))
        .sorted(Comparator.comparingDouble(Disk::radius).reversed())
        .toList();
  }

  private static Disk inscribed(Points p, int a, int b, int c) {
    double opposite = side(p, b, c);
    double next = side(p, c, a);
    double last = side(p, a, b);
    double around = opposite + next + last;
    double dx = p.x(b) - p.x(a);
    double dy = p.y(b) - p.y(a);
    double area = dx * (p.y(c) - p.y(a)) - dy * (p.x(c) - p.x(a));
    double x = (opposite * p.x(a) + next * p.x(b) + last * p.x(c)) / around;
    double y = (opposite * p.y(a) + next * p.y(b) + last * p.y(c)) / around;
    return new Disk(x, y, area / around);
  }

  private static double side(Points p, int u, int v) {
    double dx = p.x(v) - p.x(u);
    double dy = p.y(v) - p.y(u);
    return Math.sqrt(dx * dx + dy * dy);
  }
}
