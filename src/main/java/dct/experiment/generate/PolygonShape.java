package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The families of random simple polygons. */
public enum PolygonShape {
  /** 2-opt moves from a random tour. */
  TWO_OPT("two-opt", "2-opt", "random points, untangled by 2-opt; slow above 30,000"),
  /** Steady Growth. */
  STEADY_GROWTH(
      "steady-growth", "Steady Growth", "grown outwards, point by point; slow above 30,000"),
  /** Space Partitioning. */
  SPACE_PARTITIONING(
      "space-partitioning", "Space Partitioning", "random points, split by random lines"),
  /** Star-shaped. */
  STAR_SHAPED("star-shaped", "Star-shaped", "random points about one that sees all"),
  /** Monotone in x. */
  X_MONOTONE("x-monotone", "x-Monotone", "two chains from left to right"),
  /** Strictly convex. */
  CONVEX("convex", "Convex", "uniform among strictly convex polygons"),
  /** Level and upright edges in turn. */
  ORTHOGONAL("orthogonal", "Orthogonal", "level and upright edges in turn"),
  /** A toothed polygon. */
  COMB("comb", "Comb", "pointed teeth on a straight back"),
  /** A wound corridor. */
  SPIRAL("spiral", "Spiral", "a corridor wound up"),
  /** The outline of a random tree. */
  SPANNING_TREE("spanning-tree", "Spanning Tree", "the outline of a random spanning tree"),
  /** 2-opt moves from a tour along a Hilbert curve. */
  TOUR("tour", "Tour", "random points, toured along a Hilbert curve and untangled"),
  /** Few points, their edges bent into arcs. */
  BENT_EDGES("bent-edges", "Bent Edges", "few random points, their edges bent out or in");

  /** The largest number of vertices that can be asked for. */
  public static final int MOST = 10_000_000;

  private static final int LEAST = 3;

  private final String word;
  private final String title;
  private final String description;

  PolygonShape(String word, String title, String description) {
    this.word = word;
    this.title = title;
    this.description = description;
  }

  /** The name on the command line. */
  public String word() {
    return word;
  }

  /** The name in the window. */
  public String title() {
    return title;
  }

  /** What these polygons are, in a few words. */
  public String description() {
    return description;
  }

  /** The shape of this name. */
  public static Optional<PolygonShape> of(String word) {
    return Arrays.stream(values()).filter(shape -> shape.word.equals(word)).findFirst();
  }

  /** The names of all, for menus and messages. */
  public static List<String> words() {
    return Arrays.stream(values()).map(PolygonShape::word).toList();
  }

  /** A polygon in the area that {@link #areaFor} gives, from {@link Area#CANVAS}. */
  public SimplePolygon generate(int n, long seed) {
    return generate(n, areaFor(n), seed, Progress.NONE);
  }

  /**
   * Makes a polygon of exactly n vertices, counter-clockwise; the same for the same shape, n, area
   * and seed on every machine and JDK.
   *
   * @throws CannotGenerateException if there is none, or none was found
   * @throws java.util.concurrent.CancellationException if the caller asked to stop
   */
  public SimplePolygon generate(int n, Area area, long seed, Progress progress) {
    check(n);
    return SimplePolygon.of(points(n, area, new SeededRandom(seed), progress), progress);
  }

  /** The vertices, counter-clockwise. */
  private Points points(int n, Area area, SeededRandom random, Progress progress) {
    return switch (this) {
      case TWO_OPT -> Untangling.fromRandomTour(n, area, random, progress);
      case STEADY_GROWTH -> SteadyGrowth.polygon(n, area, random, progress);
      case SPACE_PARTITIONING -> SpacePartitioning.polygon(n, area, random, progress);
      case STAR_SHAPED -> StarShaped.polygon(n, area, random, progress);
      case X_MONOTONE -> MonotoneChains.polygon(n, area, random, progress);
      case CONVEX -> ConvexPosition.polygon(n, area, random, progress);
      case ORTHOGONAL -> Orthogonal.polygon(n, area, random, progress);
      case COMB -> Comb.polygon(n, area, random, progress);
      case SPIRAL -> Spiral.polygon(n, area, random, progress);
      case SPANNING_TREE -> SpanningTree.polygon(n, area, random, progress);
      case BENT_EDGES -> BentEdges.polygon(n, area, random, progress);
      case TOUR -> Untangling.fromHilbertTour(n, area, random, progress);
    };
  }

  private static void check(int n) {
    if (n < LEAST || n > MOST) {
      throw new CannotGenerateException(
          String.format(
              Locale.ROOT,
              "the number of vertices of a random polygon is from %d to %d; %d is not",
              LEAST,
              MOST,
              n));
    }
  }

  /**
   * The canvas, both sides doubled until n vertices of this shape have room, with real coordinates
   * where whole ones do not suffice.
   */
  public Area areaFor(int n) {
    Area area = Area.CANVAS;
    while (!hasRoom(n, area)) {
      if (!area.canDouble()) {
        return Area.CANVAS.real();
      }
      area = area.doubled();
    }
    return area;
  }

  private boolean hasRoom(int n, Area area) {
    double shorter = Math.min(area.width(), area.height());
    return switch (this) {
      case CONVEX -> (double) n * n * n <= shorter * shorter;
      case ORTHOGONAL -> 8L * n <= (long) area.width() * area.height();
      case COMB, SPIRAL -> n <= shorter;
      case BENT_EDGES -> false; // real coordinates only
      default -> 2L * n <= (long) area.width() * area.height();
    };
  }
}
