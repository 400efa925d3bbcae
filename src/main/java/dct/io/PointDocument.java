package dct.io;

import dct.core.Progress;
import dct.core.geometry.Defect;
import dct.core.geometry.InvalidGeometryException;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Domain;
import java.util.Arrays;
import java.util.Optional;

/**
 * What a file of points holds, and where in the file each point stands; immutable.
 *
 * <p>The points are finite numbers, no more has been checked: {@link #polygon} and {@link #sites}
 * do that.
 */
public final class PointDocument {
  private final String source;
  private final Optional<Domain> declared;
  private final Points points;
  private final int[] lines; // the line of each point

  PointDocument(String source, Optional<Domain> declared, Points points, int[] lines) {
    this.source = source;
    this.declared = declared;
    this.points = points;
    this.lines = lines;
  }

  /** Points that come from no file, each on the line that a file without comments gives it. */
  public static PointDocument of(String source, Domain domain, Points points) {
    int[] lines = new int[points.size()];
    Arrays.setAll(lines, i -> i + 1);
    return new PointDocument(source, Optional.of(domain), points, lines);
  }

  /** The same points, said to be of this domain. */
  public PointDocument declared(Domain domain) {
    return new PointDocument(source, Optional.of(domain), points, lines);
  }

  /** The file's name as the user gave it, or "-" for standard input. */
  public String source() {
    return source;
  }

  /** What the file's name, or else its contents, say that the points are; nothing if neither. */
  public Optional<Domain> declared() {
    return declared;
  }

  /** The points, in the order of the file. */
  public Points points() {
    return points;
  }

  /** The line of the file that point i stands on, from 1 on. */
  public int line(int i) {
    return lines[i];
  }

  /**
   * The points as a polygon, in O(n log n).
   *
   * @throws BadInputException if they do not bound a simple polygon
   */
  public SimplePolygon polygon() {
    try {
      return SimplePolygon.of(points, Progress.NONE);
    } catch (InvalidGeometryException e) {
      throw bad(e.defect());
    }
  }

  /**
   * The points as sites, duplicates merged, in O(n log n).
   *
   * @throws BadInputException if there are fewer than three points
   */
  public Sites sites() {
    if (points.size() < 3) {
      throw bad(new Defect(Defect.Kind.TOO_FEW, 0, 0, 0, 0, points.size()));
    }
    return Sites.of(points, Progress.NONE);
  }

  /**
   * The points as sites that have a triangulation.
   *
   * @throws BadInputException if there are fewer than three points, or all lie on one line
   */
  public Sites sitesNotOnOneLine() {
    Sites sites = sites();
    if (areOnOneLine(sites.points())) {
      throw bad(new Defect(Defect.Kind.COLLINEAR, 0, 0, points.x(0), points.y(0), points.size()));
    }
    return sites;
  }

  private static boolean areOnOneLine(Points sites) {
    for (int i = 2; i < sites.size(); i++) {
      if (sites.orient(0, 1, i) != 0) {
        return false;
      }
    }
    return true;
  }

  private BadInputException bad(Defect defect) {
    return new BadInputException(source, lineOf(defect), defect.message());
  }

  private int lineOf(Defect defect) {
    if (points.size() == 0) {
      return 1;
    }
    return switch (defect.kind()) {
      case TOO_FEW -> lines[points.size() - 1];
      case DUPLICATE -> lines[Math.max(defect.first(), defect.second())]; // the one to remove
      default -> lines[defect.first()];
    };
  }
}
