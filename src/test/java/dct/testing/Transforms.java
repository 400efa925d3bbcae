package dct.testing;

import dct.core.geometry.Points;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.IntUnaryOperator;

/** Images of a figure that must make no difference; all exact, so that no degeneracy is lost. */
public final class Transforms {

  /** A figure and what was done to it. */
  public record Named(String name, Points points) {
    @Override
    public String toString() {
      return name;
    }
  }

  private Transforms() {}

  /** Four rotations, each plain and mirrored, each in both orientations: 16 figures. */
  public static List<Named> all(Points points) {
    List<Named> images = new ArrayList<>();
    for (int quarter = 0; quarter < 4; quarter++) {
      Points turned = rotated(points, quarter);
      String name = "rotated " + 90 * quarter + "°";
      images.add(new Named(name, turned));
      images.add(new Named(name + ", reversed", reversed(turned)));
      images.add(new Named(name + ", mirrored", mirrored(turned)));
      images.add(new Named(name + ", mirrored, reversed", reversed(mirrored(turned))));
    }
    return images;
  }

  /** The figure itself and two scales that are far from it; coordinates stay exact multiples. */
  public static List<Named> scales(Points points) {
    return List.of(
        new Named("as it is", points),
        new Named("2^-300 times", scaled(points, 0x1p-300)),
        new Named("2^300 times", scaled(points, 0x1p300)));
  }

  /** Turned by quarter turns, counter-clockwise. */
  public static Points rotated(Points points, int quarters) {
    return switch (quarters & 3) {
      case 1 -> map(points, (x, y) -> -y, (x, y) -> x);
      case 2 -> map(points, (x, y) -> -x, (x, y) -> -y);
      case 3 -> map(points, (x, y) -> y, (x, y) -> -x);
      default -> points;
    };
  }

  /** Mirrored in the y-axis. */
  public static Points mirrored(Points points) {
    return map(points, (x, y) -> -x, (x, y) -> y);
  }

  /** Every coordinate times a factor, which a test chooses as a power of two. */
  public static Points scaled(Points points, double factor) {
    return map(points, (x, y) -> x * factor, (x, y) -> y * factor);
  }

  /** Every coordinate moved; exact only where the test knows it to be. */
  public static Points moved(Points points, double dx, double dy) {
    return map(points, (x, y) -> x + dx, (x, y) -> y + dy);
  }

  /**
   * Whole-number coordinates taken as numbers of ulps above 1, so that neighbours differ in the
   * last bit; the figure stays exactly similar.
   */
  public static Points ulps(Points wholeNumbers) {
    return map(wholeNumbers, (x, y) -> 1.5 + x * 0x1p-52, (x, y) -> 1.5 + y * 0x1p-52);
  }

  private static Points map(Points points, DoubleBinaryOperator toX, DoubleBinaryOperator toY) {
    double[] x = new double[points.size()];
    double[] y = new double[points.size()];
    for (int i = 0; i < x.length; i++) {
      x[i] = toX.applyAsDouble(points.x(i), points.y(i));
      y[i] = toY.applyAsDouble(points.x(i), points.y(i));
    }
    return Points.of(x, y);
  }

  /** The same vertices from the last to the first. */
  public static Points reversed(Points points) {
    int n = points.size();
    return reordered(points, i -> n - 1 - i);
  }

  /** The same closed chain beginning at another vertex. */
  public static Points startingAt(Points points, int first) {
    return reordered(points, i -> (i + first) % points.size());
  }

  private static Points reordered(Points points, IntUnaryOperator source) {
    double[] x = new double[points.size()];
    double[] y = new double[points.size()];
    for (int i = 0; i < x.length; i++) {
      x[i] = points.x(source.applyAsInt(i));
      y[i] = points.y(source.applyAsInt(i));
    }
    return Points.of(x, y);
  }
}
