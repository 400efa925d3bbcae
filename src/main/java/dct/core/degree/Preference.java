package dct.core.degree;

import dct.core.geometry.Points;
import dct.core.geometry.SmallestAngle;
import dct.core.triangulate.Triangulation;
import java.util.Arrays;
import java.util.Optional;

/**
 * Which of the triangulations that grant equally many wishes is preferred; immutable.
 *
 * <p>What is compared is a number, the {@link #value} of a triangulation. It is computed in a way
 * that is the same on all machines.
 */
public final class Preference {

  /** What is compared. */
  public enum Kind {
    /** The smallest of all angles, in degrees; the larger, the better. */
    ANGLE("angle", "smallestAngle"),
    /** The length of all edges together; the less, the better. */
    LENGTH("length", "totalLength"),
    /** How many edges are also edges of a given triangulation; the more, the better. */
    KEPT("kept", "keptEdges");

    private final String word;
    private final String field;

    Kind(String word, String field) {
      this.word = word;
      this.field = field;
    }

    /** Its word on the command line and in files. */
    public String word() {
      return word;
    }

    /** The name of the value in files. */
    public String field() {
      return field;
    }

    /** The kind with this word. */
    public static Optional<Kind> of(String word) {
      return Arrays.stream(values()).filter(kind -> kind.word.equals(word)).findFirst();
    }
  }

  /** The relative difference up to which two values count as equal where one is proven best. */
  public static final double TOLERANCE = 1e-6;

  /** The largest smallest angle. */
  public static final Preference ANGLE = new Preference(Kind.ANGLE, new long[0]);

  /** The least total length. */
  public static final Preference LENGTH = new Preference(Kind.LENGTH, new long[0]);

  private final Kind kind;
  private final long[] given; // the edges to be kept, sorted

  private Preference(Kind kind, long[] given) {
    this.kind = kind;
    this.given = given;
  }

  /** The most edges kept from a triangulation of the same points. */
  public static Preference keeping(Triangulation given) {
    int[] ends = new int[2 * given.edgeCount()];
    Arrays.setAll(ends, e -> given.dcel().origin(e));
    return keeping(ends);
  }

  /** The most edges kept of these: the ends of the first, of the second, … */
  public static Preference keeping(int... ends) {
    long[] keys = new long[ends.length / 2];
    Arrays.setAll(keys, edge -> key(ends[2 * edge], ends[2 * edge + 1]));
    Arrays.sort(keys);
    return new Preference(Kind.KEPT, keys);
  }

  private static long key(int u, int v) {
    return (long) Math.min(u, v) << Integer.SIZE | Math.max(u, v);
  }

  /** What is compared. */
  public Kind kind() {
    return kind;
  }

  /** Whether the edge between two vertices is one of those to be kept. */
  public boolean isGiven(int u, int v) {
    return Arrays.binarySearch(given, key(u, v)) >= 0;
  }

  /** The ends of the edges to be kept: of the first, of the second, … in ascending order. */
  public int[] given() {
    int[] ends = new int[2 * given.length];
    Arrays.setAll(ends, i -> (int) ((i & 1) == 0 ? given[i / 2] >> Integer.SIZE : given[i / 2]));
    return ends;
  }

  /** The value of a triangulation with at least one triangle. */
  public double value(Triangulation triangulation) {
    return switch (kind) {
      case ANGLE -> smallestAngle(triangulation);
      case LENGTH -> totalLength(triangulation);
      case KEPT -> keptEdges(triangulation);
    };
  }

  private static double smallestAngle(Triangulation triangulation) {
    Points points = triangulation.points();
    int[] corners = triangulation.triangles();
    double worst = 0;
    for (int t = 0; t < corners.length; t += 3) {
      int a = corners[t];
      int b = corners[t + 1];
      int c = corners[t + 2];
      double cotangent =
          SmallestAngle.cotangent(
              points.x(a), points.y(a), points.x(b), points.y(b), points.x(c), points.y(c));
      worst = Math.max(worst, cotangent);
    }
    return SmallestAngle.degrees(worst);
  }

  private static double totalLength(Triangulation triangulation) {
    Points points = triangulation.points();
    double[] lengths = new double[triangulation.edgeCount()];
    for (int edge = 0; edge < lengths.length; edge++) {
      int u = triangulation.from(edge);
      int v = triangulation.to(edge);
      lengths[edge] = length(points.x(u) - points.x(v), points.y(u) - points.y(v));
    }
    Arrays.sort(lengths); // so that the sum does not depend on the numbers of the edges
    double sum = 0;
    for (double length : lengths) {
      sum += length;
    }
    return sum;
  }

  /** The length of a vector, the same on all machines. */
  public static double length(double x, double y) {
    double square = x * x + y * y;
    boolean isOrdinary = square < 0x1p1000 && square > 0x1p-900;
    return isOrdinary ? Math.sqrt(square) : StrictMath.hypot(x, y);
  }

  private int keptEdges(Triangulation triangulation) {
    int kept = 0;
    for (int edge = 0; edge < triangulation.edgeCount(); edge++) {
      kept += isGiven(triangulation.from(edge), triangulation.to(edge)) ? 1 : 0;
    }
    return kept;
  }

  /** Whether one value is better than another. */
  public boolean isBetter(double value, double other) {
    return kind == Kind.LENGTH ? value < other : value > other;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Preference that
        && kind == that.kind
        && Arrays.equals(given, that.given);
  }

  @Override
  public int hashCode() {
    return 31 * kind.hashCode() + Arrays.hashCode(given);
  }

  @Override
  public String toString() {
    return kind.word;
  }
}
