package dct.io.format.plain;

import dct.core.geometry.Points;
import dct.io.format.PointColumns;
import dct.io.format.Shape;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Text whose rows of two numbers are not all vertices: rings behind their counts and a flag, as
 * Surfer writes them, or vertices and edges behind both counts, as CDT does. Each is told only
 * where all counts fit to the last row.
 */
final class CountedText {
  private final Points rows;
  private final int[] lines;

  private CountedText(Points rows, int[] lines) {
    this.rows = rows;
    this.lines = lines;
  }

  /**
   * The shapes, if the rows are of such a form.
   *
   * @param notes hears what is left out
   */
  static Optional<List<Shape>> shapes(Points rows, int[] lines, List<String> notes) {
    CountedText text = new CountedText(rows, lines);
    if (TextLayout.isCounts(rows)) {
      notes.add(
          String.format(
              Locale.ROOT,
              "Line %d is read as counts, not as the vertex (%d, %d)",
              lines[0],
              (long) rows.x(0),
              (long) rows.y(0)));
      return Optional.of(text.rings());
    }
    return TextLayout.isCountsOfEdges(rows) ? Optional.of(text.graph(notes)) : Optional.empty();
  }

  private List<Shape> rings() {
    List<Shape> rings = new ArrayList<>();
    int i = 0;
    while (i < rows.size()) {
      int n = (int) rows.x(i);
      rings.add(Shape.of(Shape.Kind.RING, "", part(i + 1, n)));
      i += n + 1;
    }
    return rings;
  }

  /** The vertices: a ring if the edges are its sides, or else sites. */
  private List<Shape> graph(List<String> notes) {
    int n = (int) rows.x(0);
    int edges = (int) rows.y(0);
    boolean isRing = edges == n;
    for (int e = 0; e < edges && isRing; e++) {
      int u = (int) rows.x(n + 1 + e);
      int v = (int) rows.y(n + 1 + e);
      isRing = u == e && v == (e + 1) % n;
    }
    notes.add(
        String.format(
            Locale.ROOT,
            isRing
                ? "Line %d is read as counts of %d vertices and %d edges, the sides of a ring"
                : "Line %d is read as counts of %d vertices and %d edges; the edges are left out",
            lines[0],
            n,
            edges));
    Shape.Kind kind = isRing ? Shape.Kind.RING : Shape.Kind.SITES;
    return List.of(Shape.of(kind, "", part(1, n)));
  }

  private PointColumns part(int from, int size) {
    PointColumns part = new PointColumns();
    for (int i = from; i < from + size; i++) {
      part.add(rows.x(i), rows.y(i), lines[i]);
    }
    return part;
  }
}
