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
import java.util.Optional;

/** Split Vertex: a click splits the closest edge by a new vertex on it. */
public final class SplitTool implements Tool {
  private Spot hover; // null while the mouse is elsewhere

  @Override
  public String name() {
    return "Split Vertex";
  }

  @Override
  public String description() {
    return "A click splits the closest edge by a new vertex";
  }

  @Override
  public int key() {
    return KeyEvent.VK_S;
  }

  @Override
  public Cursor cursor() {
    return Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR);
  }

  @Override
  public String hint(ToolContext context) {
    return target(context)
        .map(edge -> "Click to split the edge " + edge.name())
        .orElse("Click near an edge to split it");
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
    Optional<EdgePoint> target = target(context);
    if (target.isPresent()) {
      split(context, target.get());
    } else {
      context.say("There is no edge to split yet");
    }
  }

  private static void split(ToolContext context, EdgePoint edge) {
    Document document = context.document();
    Optional<EdgePoint> settled =
        edge.exact()
            ? Optional.of(edge)
            : NearEdge.settle(document, edge, context.viewport().scale());
    if (settled.isEmpty()) {
      context.say("No number is near enough to " + edge.name() + "; click at another place of it");
      return;
    }
    EdgePoint place = settled.get();
    int there = document.vertexAt(place.x(), place.y());
    if (there >= 0) {
      context.say("v" + there + " is already there; click farther from it, or zoom in");
      return;
    }
    Edit split = Edit.split(document, place.from(), place.to(), place.x(), place.y());
    context.perform(split);
    if (!place.exact()) {
      int number = context.document().vertexAt(place.x(), place.y());
      context.say("v" + number + " is a rounding away from the edge: no number is nearer to it");
    }
  }

  private Optional<EdgePoint> target(ToolContext context) {
    // While a large document is being analysed, the edges shown are those of an older one.
    return hover == null || !context.shown().document().equals(context.document())
        ? Optional.empty()
        : Pick.edge(context.shown(), context.viewport(), hover, edges(context.document()));
  }

  /** The edges that can be split: of a polygon those of its rings, and the fixed ones. */
  private static Pick.EdgeTest edges(Document document) {
    return document.domain() == Domain.SITES ? (u, v) -> true : document.rings()::isEdge;
  }

  @Override
  public void paint(ToolContext context, Pen pen) {
    target(context).ifPresent(edge -> paint(context, edge, pen));
  }

  private static void paint(ToolContext context, EdgePoint edge, Pen pen) {
    Viewport view = context.viewport();
    Points points = context.document().points();
    pen.style(Stroke.solid(Ink.HIGHLIGHT, 2.5));
    Pick.line(pen, view, points, edge.from(), edge.to());
    pen.disc(view.screenX(edge.x()), view.screenY(edge.y()), 4);
  }
}
