package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The families of random sites. */
public enum SiteShape {
  /** Uniform in the area. */
  UNIFORM("uniform", "Uniform", "uniform in the whole area"),
  /** Uniform in a disk. */
  DISK("disk", "Disk", "uniform in a disk"),
  /** Normally distributed clusters. */
  CLUSTERS("clusters", "Clusters", "in clusters, each normally distributed"),
  /** A square lattice. */
  LATTICE("lattice", "Lattice", "on a square lattice"),
  /** A disturbed lattice. */
  JITTERED_LATTICE("jittered-lattice", "Lattice with Jitter", "one in each square of a lattice"),
  /** A circle. */
  CIRCLE("circle", "Circle", "on a circle, rounded to places"),
  /** Many on each of a few lines. */
  LINES("lines", "Lines", "on lines, many on each");

  /** The largest number of sites that can be asked for. */
  public static final int MOST = 100_000_000;

  private final String word;
  private final String title;
  private final String description;

  SiteShape(String word, String title, String description) {
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

  /** How these sites lie, in a few words. */
  public String description() {
    return description;
  }

  /** The shape of this name. */
  public static Optional<SiteShape> of(String word) {
    return Arrays.stream(values()).filter(shape -> shape.word.equals(word)).findFirst();
  }

  /** The names of all, for menus and messages. */
  public static List<String> words() {
    return Arrays.stream(values()).map(SiteShape::word).toList();
  }

  /** Sites in the area that {@link #areaFor} gives. */
  public Points generate(int n, long seed) {
    return generate(n, areaFor(n), seed, Progress.NONE);
  }

  /**
   * Makes exactly n sites, all different; the same for the same shape, n, area and seed on every
   * machine and JDK.
   *
   * @throws CannotGenerateException if there are none, or none were found
   * @throws java.util.concurrent.CancellationException if the caller asked to stop
   */
  public Points generate(int n, Area area, long seed, Progress progress) {
    if (n < 1 || n > MOST) {
      throw new CannotGenerateException(
          String.format(
              Locale.ROOT, "the number of random sites is from 1 to %d; %d is not", MOST, n));
    }
    SeededRandom random = new SeededRandom(seed);
    return switch (this) {
      case UNIFORM -> Places.distinct(n, area.grid(), random).points();
      case DISK -> ScatteredSites.disk(n, area, random, progress);
      case CLUSTERS -> ScatteredSites.clusters(n, area, random, progress);
      case LATTICE -> LatticeSites.sites(n, area, null);
      case JITTERED_LATTICE -> LatticeSites.sites(n, area, random);
      case CIRCLE -> ScatteredSites.circle(n, area, random, progress);
      case LINES -> ScatteredSites.lines(n, area, random, progress);
    };
  }

  /**
   * The canvas, both sides doubled until n sites of this shape have ample room: for uniform ones,
   * until half of the places stay free.
   */
  public Area areaFor(int n) {
    Area area = Area.CANVAS;
    while (!hasRoom(n, area) && area.canDouble()) {
      area = area.doubled();
    }
    return area;
  }

  private boolean hasRoom(int n, Area area) {
    long places = (long) area.width() * area.height();
    return switch (this) {
      case UNIFORM -> 2L * n <= places;
      case CIRCLE -> n <= Math.min(area.width(), area.height());
      default -> 16L * n <= places;
    };
  }
}
