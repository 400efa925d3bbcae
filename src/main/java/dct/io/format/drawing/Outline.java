package dct.io.format.drawing;

import dct.io.format.PointColumns;

/** The vertices of one ring or path as they are drawn. */
final class Outline {
  private final XmlText xml;
  private final Affine matrix;
  private final PointColumns columns = new PointColumns();
  private int size;
  private double firstX;
  private double firstY;
  private double lastX;
  private double lastY;
  private int lastLine;
  private boolean closed;

  /** An outline whose vertices are mapped. */
  Outline(XmlText xml, Affine matrix) {
    this.xml = xml;
    this.matrix = matrix;
  }

  /**
   * Adds a vertex.
   *
   * @throws dct.io.text.BadInputException if it is beyond the range of double
   */
  void add(double px, double py, int line) {
    double x = matrix.x(px, py);
    double y = matrix.y(px, py);
    xml.checkFinite(x, y, line);
    if (size == 0) {
      firstX = x;
      firstY = y;
    } else {
      columns.add(lastX, lastY, lastLine);
    }
    lastX = x;
    lastY = y;
    lastLine = line;
    size++;
  }

  /** Says that an edge leads from the last vertex to the first; nothing is added after. */
  void close() {
    closed = true;
  }

  int size() {
    return size;
  }

  boolean isClosed() {
    return closed;
  }

  /** The vertices; a last one that is there to close the ring is left out, which closes it. */
  PointColumns finished() {
    if (!closed && size > 1 && firstX == lastX && firstY == lastY) {
      closed = true;
    } else if (size > 0) {
      columns.add(lastX, lastY, lastLine);
    }
    return columns;
  }
}
