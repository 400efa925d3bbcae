package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The families of random regions with holes. */
public enum RegionShape {
  /** One hole in the middle. */
  ANNULUS("annulus", "Annulus", "a random polygon in the middle of a star-shaped one"),
  /** Holes in a polygon of the tour family. */
  HOLES("holes", "With holes", "a toured polygon with star-shaped holes where it is widest"),
  /** Holes in an orthogonal polygon. */
  COURTYARDS(
      "courtyards",
      "Courtyards",
      "an orthogonal polygon with rectangular holes where it is widest");

  private static final int LEAST = 3; // vertices of a ring
  private static final int CORNERS = 4; // of a courtyard

  private final String word;
  private final String title;
  private final String description;

  RegionShape(String word, String title, String description) {
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

  /** What these regions are, in a few words. */
  public String description() {
    return description;
  }

  /** The shape of this name. */
  public static Optional<RegionShape> of(String word) {
    return Arrays.stream(values()).filter(shape -> shape.word.equals(word)).findFirst();
  }

  /** The names of all, for messages. */
  public static List<String> words() {
    return Arrays.stream(values()).map(RegionShape::word).toList();
  }

  /**
   * Makes a region of exactly n vertices, all on rings, with so many holes; the same for the same
   * shape, numbers and seed on every machine and JDK. The vertices of a ring have successive
   * numbers, the outer ring comes first.
   *
   * @throws CannotGenerateException if there is none, or none was found
   * @throws java.util.concurrent.CancellationException if the caller asked to stop
   */
  public Region generate(int n, int holes, long seed, Progress progress) {
    SeededRandom random = new SeededRandom(seed);
    int[] sizes = sizes(n, holes, random);
    List<Points> chains =
        this == ANNULUS
            ? Nested.annulus(sizes[0], sizes[1], random, progress)
            : Nested.holes(outer(), this == COURTYARDS, sizes, random, progress);
    return Region.of(rings(chains), progress);
  }

  private PolygonShape outer() {
    return this == COURTYARDS ? PolygonShape.ORTHOGONAL : PolygonShape.TOUR;
  }

  /** The numbers of vertices of the outer ring and of each hole; of an annulus they vary. */
  private int[] sizes(int n, int holes, SeededRandom random) {
    int least = this == COURTYARDS ? CORNERS : LEAST;
    boolean many = this == ANNULUS && holes > 1;
    if (holes < 1 || many || n < least * (holes + 1) || n > PolygonShape.MOST) {
      throw new CannotGenerateException(
          String.format(
              Locale.ROOT,
              "%s of %d vertices cannot have %d %s; each ring has %d vertices or more, and there is %s",
              this == ANNULUS ? "an annulus" : "a region",
              n,
              holes,
              holes == 1 ? "hole" : "holes",
              least,
              this == ANNULUS ? "one hole" : "a hole at least"));
    }
    int[] sizes = new int[holes + 1];
    int each =
        switch (this) {
          case ANNULUS -> Math.max(LEAST, n / 2 - random.nextInt(n / 6 + 1));
          case HOLES -> Math.max(LEAST, n / (2 * holes + 1));
          case COURTYARDS -> CORNERS;
        };
    Arrays.fill(sizes, each);
    sizes[0] = n - holes * sizes[1];
    return sizes;
  }

  private static Rings rings(List<Points> chains) {
    int n = chains.stream().mapToInt(Points::size).sum();
    double[] x = new double[n];
    double[] y = new double[n];
    int count = 0;
    List<int[]> rings = new ArrayList<>();
    for (Points chain : chains) {
      int[] ring = new int[chain.size()];
      for (int k = 0; k < ring.length; k++) {
        ring[k] = count;
        x[count] = chain.x(k);
        y[count++] = chain.y(k);
      }
      rings.add(ring);
    }
    return Rings.of(Points.of(x, y), rings);
  }
}
