package dct.io.format;

import dct.core.triangulate.Domain;
import java.util.List;
import java.util.Optional;

/**
 * What was read from a file.
 *
 * @param format the title of its format
 * @param shapes in the order of the file, at least one
 * @param notes what was left out, a sentence each without a full stop, as {@code 3 comments and a z
 *     column left out}
 * @param region the same as one region, if that holds more than the shapes tell
 * @param isRegion whether the file says that the shapes are one region
 */
public record Shapes(
    String format,
    List<Shape> shapes,
    List<String> notes,
    Optional<Whole> region,
    boolean isRegion) {

  /** Copies the lists. */
  public Shapes {
    shapes = List.copyOf(shapes);
    notes = List.copyOf(notes);
  }

  /**
   * What a file holds, as one region.
   *
   * @param notes what was left out then
   * @param fault why it has no rings, if more is known than that
   */
  public record Whole(RegionShape shape, List<String> notes, Optional<Fault> fault) {
    /** Copies the list. */
    public Whole {
      notes = List.copyOf(notes);
    }

    /** One of which no more is known. */
    public Whole(RegionShape shape, List<String> notes) {
      this(shape, notes, Optional.empty());
    }
  }

  /**
   * What is wrong in a file that can be read in another way.
   *
   * @param line the line, from 1 on
   * @param what what is wrong and, after a semicolon, what would mend it
   */
  public record Fault(int line, String what) {}

  /** Shapes of which the file does not say that they are a region. */
  public Shapes(String format, List<Shape> shapes, List<String> notes) {
    this(format, shapes, notes, Optional.empty(), false);
  }

  /**
   * The regions that the shapes make: that which the file says it holds, or else one for each ring,
   * with the holes and sites that follow it. Where the file does not tell rings from holes, all its
   * rings are of one region. The rims of triangles are rings, too.
   */
  public List<RegionShape> regions() {
    return region.map(whole -> List.of(whole.shape())).orElseGet(() -> RegionShape.all(shapes));
  }

  /** Whether a region is asked for, or else the file says that it holds one. */
  public boolean areRegion(Optional<Domain> as) {
    return as.map(Domain.REGION::equals).orElse(isRegion);
  }

  /** A file with one shape, of which nothing was left out. */
  public static Shapes of(String format, Shape shape) {
    return new Shapes(format, List.of(shape), List.of());
  }
}
