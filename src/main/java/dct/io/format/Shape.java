package dct.io.format;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import java.util.Optional;

/**
 * A list of points that a file holds.
 *
 * <p>The points are finite, no more has been checked. A ring does not repeat its first vertex at
 * its end where its format asks for that; where people may or may not have written it, it still
 * does.
 */
public final class Shape {
  private final Kind kind;
  private final String label;
  private final Points points;
  private final int[] lines;
  private final Optional<StoredFaces> faces;

  /**
   * A shape.
   *
   * @param kind what the points are
   * @param label what lists call it: a name that stands in the file; may be empty
   * @param points the points in the order of the file
   * @param lines the line of each point, from 1 on; it is not copied
   * @param faces a triangulation of the points, if the file holds one
   */
  public Shape(Kind kind, String label, Points points, int[] lines, Optional<StoredFaces> faces) {
    this.kind = kind;
    this.label = label;
    this.points = points;
    this.lines = lines;
    this.faces = faces;
  }

  /** What the points of a shape are. */
  public enum Kind {
    /** The boundary of a polygon. */
    RING("ring"),
    /** The boundary of a hole in the nearest ring before it. */
    HOLE("hole"),
    /** A sequence of vertices that is not closed; it is read as a ring. */
    PATH("path"),
    /** Points without an order that means anything. */
    SITES("sites"),
    /** The file does not tell whether they are a ring or sites. */
    POINTS("points");

    private final String word;

    Kind(String word) {
      this.word = word;
    }

    /** The word for it in lists. */
    public String word() {
      return word;
    }
  }

  /** The same without its triangulation. */
  public Shape withoutFaces() {
    return new Shape(kind, label, points, lines, Optional.empty());
  }

  /** A shape that is not triangulated. */
  public static Shape of(Kind kind, String label, PointColumns columns) {
    return new Shape(kind, label, columns.points(), columns.lines(), Optional.empty());
  }

  /** What the points are. */
  public Kind kind() {
    return kind;
  }

  /** What lists call it; may be empty. */
  public String label() {
    return label;
  }

  /** The points in the order of the file. */
  public Points points() {
    return points;
  }

  /** The lines of all points, from 1 on; a copy. */
  public int[] lines() {
    return lines.clone();
  }

  /** The line of point i, from 1 on. */
  public int line(int i) {
    return lines[i];
  }

  /** The triangulation of the points that the file says it holds, if it holds one. */
  public Optional<StoredFaces> faces() {
    return faces;
  }

  /** What the shape is said to be; nothing if the file does not tell. */
  public Optional<Domain> domain() {
    return switch (kind) {
      case RING, HOLE, PATH -> Optional.of(Domain.POLYGON);
      case SITES -> Optional.of(Domain.SITES);
      case POINTS -> Optional.empty();
    };
  }

  /** One line for a list: its name, what it is, and its size. */
  public String description() {
    int n = points.size();
    boolean isList = kind == Kind.SITES || kind == Kind.POINTS;
    String what = isList ? n + " " + kind.word() : kind.word() + " of " + n + " vertices";
    String all = what + (faces.isPresent() ? ", triangulated" : "");
    return label.isEmpty() ? all : label + ", " + all;
  }
}
