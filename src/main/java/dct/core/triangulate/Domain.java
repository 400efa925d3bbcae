package dct.core.triangulate;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** What was triangulated. */
public enum Domain {
  /** The inside of a simple polygon: every vertex is on the boundary. */
  POLYGON("polygon", "polygon", "vertices"),
  /** The convex hull of point sites. */
  SITES("points", "sites", "sites"),
  /** A region with holes, sites inside or fixed edges. */
  REGION("region", "region", "vertices");

  private final String word;
  private final String title;
  private final String vertices;

  Domain(String word, String title, String vertices) {
    this.word = word;
    this.title = title;
    this.vertices = vertices;
  }

  /** The word for it in files and on the command line. */
  public String word() {
    return word;
  }

  /** What people call it. */
  public String title() {
    return title;
  }

  /** What people call its vertices. */
  public String vertices() {
    return vertices;
  }

  /** The two applications of the thesis, one for polygons and one for sites. */
  public static List<Domain> applications() {
    return List.of(POLYGON, SITES);
  }

  /** The application that shows it: regions belong to that of polygons. */
  public Domain application() {
    return this == SITES ? SITES : POLYGON;
  }

  /** The domain that a word stands for, or nothing for any other word. */
  public static Optional<Domain> parse(String word) {
    return Arrays.stream(values()).filter(domain -> domain.word.equals(word)).findFirst();
  }
}
