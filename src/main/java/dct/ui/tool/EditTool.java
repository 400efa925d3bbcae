package dct.ui.tool;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.render.Pen;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import java.awt.Cursor;
import java.awt.event.KeyEvent;

/** Edit Vertex: drags a vertex; what is drawn follows. One drag is one edit. */
public final class EditTool implements Tool {
  private int vertex = -1; // under the mouse, or dragged
  private Document start; // before the drag; null while nothing is dragged
  private Spot pressed;

  @Override
  public String name() {
    return "Edit Vertex";
  }

  @Override
  public String description() {
    return "A drag moves a vertex";
  }

  @Override
  public int key() {
    return KeyEvent.VK_E;
  }

  @Override
  public Cursor cursor() {
    return Cursor.getPredefinedCursor(Cursor.HAND_CURSOR);
  }

  @Override
  public String hint(ToolContext context) {
    if (start != null) {
      return "Release to leave v" + vertex + " here; Esc puts it back";
    }
    return vertex < 0 ? "Drag a vertex to move it" : "Drag to move v" + vertex;
  }

  @Override
  public void moved(ToolContext context, Spot spot) {
    vertex = Pick.vertex(context.document().points(), context.viewport(), spot);
  }

  @Override
  public void left(ToolContext context) {
    if (start == null) {
      vertex = -1;
    }
  }

  @Override
  public void pressed(ToolContext context, Spot spot) {
    moved(context, spot);
    if (vertex >= 0) {
      start = context.document();
      pressed = spot;
    } else {
      context.say("There is no vertex here");
    }
  }

  @Override
  public void dragged(ToolContext context, Spot spot) {
    if (isDragging(context)) {
      context.preview(start.points().moved(vertex, x(context, spot), y(context, spot)));
    }
  }

  @Override
  public void released(ToolContext context, Spot spot) {
    if (isDragging(context)) {
      double x = x(context, spot);
      double y = y(context, spot);
      start = null;
      drop(context, x, y);
    }
  }

  private void drop(ToolContext context, double x, double y) {
    Document document = context.document();
    int there = document.vertexAt(x, y);
    if (there == vertex) {
      context.endPreview();
    } else if (there >= 0 && document.domain() == Domain.SITES) {
      context.endPreview();
      context.say("v" + there + " is already there; v" + vertex + " went back");
    } else {
      context.perform(Edit.move(document, vertex, x, y));
    }
  }

  @Override
  public boolean cancelled(ToolContext context) {
    boolean dragging = isDragging(context);
    start = null;
    context.endPreview();
    return dragging;
  }

  @Override
  public void paint(ToolContext context, Pen pen) {
    Points points = context.shown().document().points();
    if (vertex >= 0 && vertex < points.size()) {
      Pick.mark(pen, context.viewport(), points.x(vertex), points.y(vertex));
    }
  }

  /** An undo during the drag ends it. */
  private boolean isDragging(ToolContext context) {
    if (!context.document().equals(start)) {
      start = null;
    }
    return start != null;
  }

  /** The vertex keeps its distance from the mouse, and its place if the mouse did not move. */
  private double x(ToolContext context, Spot spot) {
    double old = start.points().x(vertex);
    double by = spot.x() - pressed.x();
    return by == 0 ? old : Spot.rounded(context.viewport(), old + by);
  }

  private double y(ToolContext context, Spot spot) {
    double old = start.points().y(vertex);
    double by = spot.y() - pressed.y();
    return by == 0 ? old : Spot.rounded(context.viewport(), old + by);
  }
}
