package dct.ui.tool;

import dct.core.geometry.Points;
import dct.core.geometry.SegmentPoints.Place;
import dct.core.triangulate.Domain;
import dct.render.Ink;
import dct.render.Pen;
import dct.render.Stroke;
import dct.render.Viewport;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import java.awt.Cursor;
import java.awt.event.KeyEvent;
import java.util.Optional;

/**
 * Draw Vertex: a click appends a vertex. A click on v0, a double click or Enter ends the drawing,
 * Backspace takes the last vertex back, Esc leaves.
 */
public final class DrawTool implements Tool {
  /** How near to the first vertex a click ends the drawing, in pixels. */
  private static final double CLOSING_REACH = 5;

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
    Document document = context.document();
    int next = document.layout().next(document.size());
    String where = hover == null ? "" : target(context, hover).words();
    if (document.domain() == Domain.SITES) {
      return "Click to add site v" + next + where + "; Enter ends";
    }
    String first = "v" + first(document);
    if (hover != null && closes(context, hover)) {
      return "Click " + first + " to end the drawing";
    }
    String of = document.layout().isHole() ? " of the hole" : "";
    return count(document) < 3
        ? "Click to add vertex v" + next + of + where
        : "Click to add v"
            + next
            + of
            + where
            + "; click "
            + first
            + ", double-click or Enter to end";
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
    if (spot.clicks() > 1) {
      clickedAgain(context);
    } else if (closes(context, spot)) {
      end(context);
    } else {
      Target target = target(context, spot);
      draw(context, target.x(), target.y());
    }
  }

  /** The first vertex of the ring that is drawn, or −1. */
  private static int first(Document document) {
    return document.layout().first(document.size());
  }

  /** How many vertices the ring has that is drawn. */
  private static int count(Document document) {
    return document.layout().openSize(document.size());
  }

  /** The second click of a double click is no vertex. */
  private void clickedAgain(ToolContext context) {
    if (context.document().domain() == Domain.POLYGON && count(context.document()) > 2) {
      end(context);
    }
  }

  private static void draw(ToolContext context, double x, double y) {
    Document document = context.document();
    int there = document.vertexAt(x, y);
    if (there >= 0) {
      context.say("v" + there + " is already there; nothing was added");
    } else {
      context.perform(Edit.draw(document, x, y));
    }
  }

  /** Where a click adds a vertex. */
  private static Target target(ToolContext context, Spot spot) {
    Points points = context.document().points();
    int last = context.document().layout().last(points.size());
    Optional<Place> origin =
        last < 0 ? Optional.empty() : Optional.of(new Place(points.x(last), points.y(last)));
    return Snapping.of(context, spot, origin, v -> false);
  }

  /** Whether this place is that of the first vertex of the ring that is drawn, or snaps to it. */
  private static boolean closes(ToolContext context, Spot spot) {
    Document document = context.document();
    Points points = document.points();
    int first = first(document);
    return document.domain() == Domain.POLYGON
        && count(document) > 2
        && (Pick.distance(points, context.viewport(), first, spot) <= CLOSING_REACH
            || target(context, spot).isAt(points.x(first), points.y(first)));
  }

  private void end(ToolContext context) {
    hover = null;
    context.chooseEdit();
  }

  @Override
  public boolean keyPressed(ToolContext context, Key key) {
    switch (key.code()) {
      case KeyEvent.VK_ENTER -> enter(context);
      case KeyEvent.VK_ESCAPE -> end(context);
      case KeyEvent.VK_BACK_SPACE -> takeBack(context);
      default -> {
        return false;
      }
    }
    return true;
  }

  private void enter(ToolContext context) {
    Document document = context.document();
    if (document.domain() == Domain.POLYGON && count(document) < 3) {
      String what = document.layout().isHole() ? "A hole" : "A polygon";
      context.say(what + " has three vertices or more; Esc leaves the drawing as it is");
    } else {
      end(context);
    }
  }

  private static void takeBack(ToolContext context) {
    Document document = context.document();
    int last = document.layout().last(document.size());
    if (last >= 0) {
      context.perform(Edit.delete(document, last));
    } else {
      context.say("There is no vertex to take back");
    }
  }

  /** Shows the edges that the next click would make; the closing one is dashed. */
  @Override
  public void paint(ToolContext context, Pen pen) {
    if (hover == null) {
      return;
    }
    Document document = context.document();
    Points points = document.points();
    Viewport view = context.viewport();
    int first = first(document);
    if (closes(context, hover)) {
      Pick.mark(pen, view, points.x(first), points.y(first));
      return;
    }
    Target target = target(context, hover);
    if (document.domain() == Domain.POLYGON && first >= 0) {
      pen.style(Stroke.solid(Ink.PROPOSED, 1.4));
      edge(view, points, document.layout().last(points.size()), target, pen);
      pen.style(Stroke.dashed(Ink.PROPOSED, 1.4));
      edge(view, points, first, target, pen);
    }
    target.mark(pen, view);
  }

  private static void edge(Viewport view, Points points, int v, Target target, Pen pen) {
    pen.line(
        view.screenX(points.x(v)),
        view.screenY(points.y(v)),
        view.screenX(target.x()),
        view.screenY(target.y()));
  }
}
