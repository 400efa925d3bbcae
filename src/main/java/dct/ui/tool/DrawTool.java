package dct.ui.tool;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.render.Ink;
import dct.render.Pen;
import dct.render.Stroke;
import dct.render.Viewport;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import java.awt.Cursor;
import java.awt.event.KeyEvent;

/** Draw Vertex: a click appends a vertex. */
public final class DrawTool implements Tool {
  private Spot hover; // null while the mouse is elsewhere

  @Override
  public String name() {
    return "Draw Vertex";
  }

  @Override
  public String description() {
    return "A click adds a vertex";
  }

  @Override
  public int key() {
    return KeyEvent.VK_D;
  }

  @Override
  public Cursor cursor() {
    return Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR);
  }

  @Override
  public String hint(ToolContext context) {
    int n = context.document().size();
    if (context.document().domain() == Domain.SITES) {
      return "Click to add site v" + n;
    }
    return n < 3
        ? "Click to add vertex v" + n
        : "Click to add vertex v" + n + " between v" + (n - 1) + " and v0";
  }

  @Override
  public void moved(ToolContext context, Spot spot) {
    hover = spot;
  }

  @Override
  public void left(ToolContext context) {
    hover = null;
  }

  @Override
  public void pressed(ToolContext context, Spot spot) {
    hover = spot;
    Document document = context.document();
    int there = document.vertexAt(spot.x(), spot.y());
    if (closes(context, spot)) {
      context.say("The polygon closes by itself, from v" + (document.size() - 1) + " to v0");
    } else if (there >= 0) {
      context.say("v" + there + " is already there; nothing was added");
    } else {
      context.perform(Edit.draw(document, spot.x(), spot.y()));
    }
  }

  /** Whether this is the click on the first vertex that closes a polygon in other programs. */
  private static boolean closes(ToolContext context, Spot spot) {
    Document document = context.document();
    return document.domain() == Domain.POLYGON
        && document.size() > 2
        && Pick.distance(document.points(), context.viewport(), 0, spot) <= 5;
  }

  /** Shows the edges that the next click would make. */
  @Override
  public void paint(ToolContext context, Pen pen) {
    Points points = context.document().points();
    if (hover == null || context.document().domain() == Domain.SITES || points.size() == 0) {
      return;
    }
    pen.style(Stroke.dashed(Ink.PROPOSED, 1.4));
    edgeFrom(context.viewport(), points, points.size() - 1, pen);
    if (points.size() > 1) {
      edgeFrom(context.viewport(), points, 0, pen);
    }
  }

  private void edgeFrom(Viewport view, Points points, int v, Pen pen) {
    pen.line(
        view.screenX(points.x(v)), view.screenY(points.y(v)), hover.screenX(), hover.screenY());
  }
}
