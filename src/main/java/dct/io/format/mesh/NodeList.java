package dct.io.format.mesh;

import dct.io.format.PointColumns;
import dct.io.format.Rows;
import dct.io.text.Shown;
import java.io.IOException;

/**
 * The vertices of Shewchuk's Triangle.
 *
 * @param points their places
 * @param first the number of the first of them, 0 or 1
 * @param hasMore whether attributes or markers stand behind the places
 */
record NodeList(PointColumns points, int first, boolean hasMore) {

  /** Reads the row of counts, the present one, and the vertices behind it. */
  static NodeList read(Rows rows) throws IOException {
    int n = rows.count(0);
    if (n == 0) {
      throw rows.fault(
          "the vertices stand in a file .node of the same name; open that, or put them in here");
    }
    int extra = rows.count(2) + rows.count(3);
    PointColumns points = new PointColumns();
    int first = 0;
    for (int v = 0; v < n; v++) {
      rows.next(v, n, "vertices");
      if (v == 0) {
        first = rows.count(0);
      }
      if (rows.count(0) != first + v || first > 1) {
        throw rows.fault("the vertices are not numbered in turn from 0 or 1 on; number them so");
      }
      points.add(rows.number(1), rows.number(2), rows.line());
    }
    return new NodeList(points, first, extra > 0);
  }

  /**
   * The place in the list of the vertex whose number is a word of the row.
   *
   * @param cure what would mend it if there is none
   */
  int vertex(Rows rows, int word, String cure) {
    int v = rows.count(word) - first;
    if (v < 0 || v >= points.size()) {
      throw rows.fault("there is no vertex " + Shown.word(rows.words().get(word)) + "; " + cure);
    }
    return v;
  }
}
