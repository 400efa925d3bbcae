package dct.ui.canvas;

import dct.core.geometry.Points;
import dct.render.Ink;
import dct.render.Pen;
import dct.render.Stroke;
import dct.render.Viewport;
import dct.ui.document.Selection;
import java.util.BitSet;

/** Marks the selected vertices that are in sight; where they crowd, one of those in each cell. */
final class SelectionMarks {
  private static final int CELL = 4; // pixels; of so many selected vertices one is marked
  private static final int CROWD = 2_000; // so many in sight are marked by squares
  private static final double RADIUS = 7.5;
  private static final double HALF_SIDE = 1.5;

  private final Viewport view;
  private final int columns;
  private final int rows;
  private final BitSet cells;
  private final double[] x; // of the marks
  private final double[] y;
  private int count;

  private SelectionMarks(Viewport view, int width, int height) {
    this.view = view;
    columns = width / CELL + 1;
    rows = height / CELL + 1;
    cells = new BitSet(columns * rows);
    x = new double[columns * rows];
    y = new double[columns * rows];
  }

  /** Draws the marks, in time linear in the number of selected vertices. */
  static void paint(
      Pen pen, Selection selection, Points points, Viewport view, int width, int height) {
    if (!selection.isEmpty() && width > 0 && height > 0) {
      SelectionMarks marks = new SelectionMarks(view, width, height);
      marks.find(selection, points);
      marks.paint(pen);
    }
  }

  private void find(Selection selection, Points points) {
    for (int v = selection.next(0); v >= 0 && v < points.size(); v = selection.next(v + 1)) {
      double px = view.screenX(points.x(v));
      double py = view.screenY(points.y(v));
      int column = (int) (px / CELL);
      int row = (int) (py / CELL);
      boolean inSight = px >= 0 && py >= 0 && column < columns && row < rows;
      if (inSight && !cells.get(row * columns + column)) {
        cells.set(row * columns + column);
        x[count] = px;
        y[count++] = py;
      }
    }
  }

  private void paint(Pen pen) {
    pen.style(Stroke.solid(Ink.HIGHLIGHT, 2.5));
    for (int k = 0; k < count; k++) {
      if (count <= CROWD) {
        pen.ring(x[k], y[k], RADIUS);
      } else {
        pen.square(x[k], y[k], HALF_SIDE);
      }
    }
  }
}
