package dct.ui.tool;

import dct.core.geometry.Points;
import dct.core.geometry.Rings;
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
 * Fix Edge: a click on a vertex and one on another, or a drag between them, fixes the edge that
 * joins them, which every triangulation has then. So does a click on a diagonal that is shown; the
 * same again lets the edge go.
 */
public final class FixTool implements Tool {
  private static final int NONE = -1;

  private Spot hover; // null while the mouse is elsewhere
  private int from = NONE; // the end that was clicked first

  @Override
  public String name() {
    return "Fix Edge";
  }

  @Override
  public String description() {
    return "Two vertices, or a diagonal, clicked: every triangulation has that edge; again: no more";
  }

  @Override
  public int key() {
    return KeyEvent.VK_T;
  }

  @Override
  public boolean isFor(Domain application) {
    return application == Domain.POLYGON;
  }

  @Override
  public Cursor cursor() {
    return Cursor.getPredefinedCursor(Cursor.HAND_CURSOR);
  }

  @Override
  public String hint(ToolContext context) {
    int vertex = vertex(context);
    if (isBegun(context)) {
      return vertex == NONE || vertex == from
          ? "Click the other end of the edge from v" + from + "; Esc lets go"
          : "Click to " + verb(context, from, vertex) + " v" + from + "–v" + vertex;
    }
    if (vertex != NONE) {
      return "Click v" + vertex + ", and then the other end of the edge to fix";
    }
    return edge(context)
        .map(e -> "Click to " + verb(context, e.from(), e.to()) + " " + e.name())
        .orElse("Click two vertices, or a diagonal, to fix the edge between them");
  }

  private static String verb(ToolContext context, int u, int v) {
    return context.document().layout().isFixed(u, v) ? "let go of" : "fix";
  }

  @Override
  public void moved(ToolContext context, Spot spot) {
    hover = spot;
  }

  @Override
  public void dragged(ToolContext context, Spot spot) {
    hover = spot;
  }

  @Override
  public void left(ToolContext context) {
    hover = null;
  }

  @Override
  public void pressed(ToolContext context, Spot spot) {
    hover = spot;
    int vertex = vertex(context);
    if (vertex != NONE) {
      clicked(context, vertex);
    } else if (isBegun(context)) {
      context.say("There is no vertex here; click the other end of the edge, or press Esc");
    } else {
      edge(context)
          .ifPresentOrElse(
              edge -> toggle(context, edge.from(), edge.to()),
              () -> context.say("There is neither a vertex nor a diagonal here"));
    }
  }

  private void clicked(ToolContext context, int vertex) {
    if (!isBegun(context)) {
      from = vertex;
    } else if (from == vertex) {
      from = NONE;
    } else {
      toggle(context, from, vertex);
    }
  }

  @Override
  public void released(ToolContext context, Spot spot) {
    hover = spot;
    int vertex = vertex(context);
    if (isBegun(context) && vertex != NONE && vertex != from) { // the end of a drag
      toggle(context, from, vertex);
    }
  }

  private void toggle(ToolContext context, int u, int v) {
    from = NONE;
    Document document = context.document();
    Rings rings = document.rings();
    String edge = "v" + Math.min(u, v) + "–v" + Math.max(u, v);
    if (rings.isEdge(u, v) && !rings.isFixed(u, v)) {
      context.say(edge + " is an edge of the polygon already");
      return;
    }
    String label = (rings.isFixed(u, v) ? "Let Go of Edge " : "Fix Edge ") + edge;
    context.perform(Edit.layout(label, document, document.layout().toggled(u, v, document.size())));
  }

  @Override
  public boolean keyPressed(ToolContext context, Key key) {
    if (!key.equals(Key.ESCAPE) || !isBegun(context)) {
      return false;
    }
    from = NONE;
    return true;
  }

  @Override
  public boolean cancelled(ToolContext context) {
    boolean begun = isBegun(context);
    from = NONE;
    return begun;
  }

  /** An undo may have taken away the vertex that was clicked. */
  private boolean isBegun(ToolContext context) {
    return from != NONE && from < context.document().size();
  }

  private int vertex(ToolContext context) {
    return hover == null
        ? NONE
        : Pick.vertex(context.document().points(), context.viewport(), hover);
  }

  /** The edge under the mouse that can be fixed or let go. */
  private Optional<EdgePoint> edge(ToolContext context) {
    if (hover == null || !context.shown().document().equals(context.document())) {
      return Optional.empty();
    }
    Rings rings = context.document().rings();
    Pick.EdgeTest inner = (u, v) -> rings.isFixed(u, v) || !rings.isEdge(u, v);
    return Pick.edge(context.shown(), context.viewport(), hover, inner)
        .filter(edge -> edge.distance(context.viewport(), hover) <= Pick.REACH);
  }

  @Override
  public void paint(ToolContext context, Pen pen) {
    Points points = context.document().points();
    Viewport view = context.viewport();
    int vertex = vertex(context);
    if (vertex != NONE) {
      Pick.mark(pen, view, points.x(vertex), points.y(vertex));
    }
    if (isBegun(context)) {
      Pick.mark(pen, view, points.x(from), points.y(from));
      paintProposed(view, points, vertex, pen);
    } else if (vertex == NONE) {
      pen.style(Stroke.solid(Ink.HIGHLIGHT, 3));
      edge(context).ifPresent(e -> Pick.line(pen, view, points, e.from(), e.to()));
    }
  }

  private void paintProposed(Viewport view, Points points, int vertex, Pen pen) {
    pen.style(Stroke.dashed(Ink.FIXED, 1.8));
    if (vertex != NONE) {
      Pick.line(pen, view, points, from, vertex);
    } else if (hover != null) {
      pen.line(
          view.screenX(points.x(from)),
          view.screenY(points.y(from)),
          hover.screenX(),
          hover.screenY());
    }
  }
}
