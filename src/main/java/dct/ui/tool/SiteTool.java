package dct.ui.tool;

import dct.core.triangulate.Domain;
import dct.render.Pen;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import java.awt.Cursor;
import java.awt.event.KeyEvent;
import java.util.Optional;

/** Inner Site: a click adds a site inside the polygon. */
public final class SiteTool implements Tool {
  private Spot hover; // null while the mouse is elsewhere

  @Override
  public String name() {
    return "Inner Site";
  }

  @Override
  public String description() {
    return "A click adds a site inside the polygon";
  }

  @Override
  public int key() {
    return KeyEvent.VK_I;
  }

  @Override
  public boolean isFor(Domain application) {
    return application == Domain.POLYGON;
  }

  @Override
  public Cursor cursor() {
    return Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR);
  }

  @Override
  public String hint(ToolContext context) {
    String where = hover == null ? "" : target(context, hover).words();
    return "Click inside the polygon to add site v" + context.document().size() + where;
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
      return; // the second click of a double click is no site
    }
    Document document = context.document();
    Target target = target(context, spot);
    int there = document.vertexAt(target.x(), target.y());
    if (there >= 0) {
      context.say("v" + there + " is already there; nothing was added");
    } else {
      context.perform(Edit.site(document, target.x(), target.y()));
    }
  }

  private static Target target(ToolContext context, Spot spot) {
    return Snapping.of(context, spot, Optional.empty(), v -> false);
  }

  @Override
  public boolean keyPressed(ToolContext context, Key key) {
    if (key.equals(Key.ESCAPE) || key.code() == KeyEvent.VK_ENTER) {
      hover = null;
      context.chooseEdit();
      return true;
    }
    return false;
  }

  @Override
  public void paint(ToolContext context, Pen pen) {
    if (hover != null) {
      target(context, hover).mark(pen, context.viewport());
    }
  }
}
