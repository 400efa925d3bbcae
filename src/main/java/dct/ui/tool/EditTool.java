package dct.ui.tool;

import dct.core.geometry.Points;
import dct.render.Pen;
import dct.ui.document.BulkEdit;
import dct.ui.document.Selection;
import java.awt.Cursor;
import java.awt.event.KeyEvent;
import java.util.Locale;

/**
 * Edit Vertex: drags a vertex; what is drawn follows. One drag is one edit.
 *
 * <p>A click selects a vertex, with Shift one more or one less; a drag over empty ground selects
 * those in a rectangle. A drag of a selected vertex, and arrows, move all that are selected. While
 * a vertex is dragged, Shift holds it to the level and the upright direction.
 */
public final class EditTool implements Tool {
  /** How far the mouse may tremble in a click, in pixels. */
  private static final double STILL = 3;

  private int vertex = -1; // under the mouse, or dragged
  private VertexDrag drag; // null while nothing is held
  private Band band; // null while no rectangle is drawn
  private boolean begun; // the mouse has moved away from where it was pressed
  private boolean wasSelected; // the vertex, before it was pressed
  private Spot pressed;
  private Target target; // where the dragged vertex goes
  private final Nudge nudge = new Nudge();

  @Override
  public String name() {
    return "Edit Vertex";
  }

  @Override
  public String description() {
    return "A drag moves a vertex; a click, or a drag over empty ground, selects";
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
    Selection selection = context.selection();
    if (drag != null) {
      String where = target == null ? "" : target.words();
      return "Release to leave v" + vertex + where + "; Esc puts it back";
    }
    if (band != null) {
      return "Release to select what is inside";
    }
    boolean all = vertex >= 0 && selection.has(vertex) && selection.count() > 1;
    if (vertex >= 0) {
      return all ? "Drag to move all that are selected" : "Drag to move v" + vertex;
    }
    return selection.isEmpty()
        ? "Drag a vertex to move it, or over empty ground to select"
        : selected(context) + ": arrows move, Delete removes, Esc lets go";
  }

  private static String selected(ToolContext context) {
    int count = context.selection().count();
    String words = BulkEdit.words(count, context.document().domain()).toLowerCase(Locale.ROOT);
    return words + " selected";
  }

  @Override
  public void moved(ToolContext context, Spot spot) {
    vertex = Pick.vertex(context.document().points(), context.viewport(), spot);
  }

  @Override
  public void left(ToolContext context) {
    if (drag == null) {
      vertex = -1;
    }
  }

  @Override
  public void pressed(ToolContext context, Spot spot) {
    nudge.end(context);
    moved(context, spot);
    pressed = spot;
    begun = false;
    target = null;
    if (vertex < 0) {
      band = new Band(spot, spot);
      return;
    }
    wasSelected = context.selection().has(vertex);
    if (!wasSelected) {
      Selection one = Selection.of(vertex);
      context.select(spot.shift() ? context.selection().or(one) : one);
    }
    drag = new VertexDrag(context.document(), context.selection());
  }

  @Override
  public void dragged(ToolContext context, Spot spot) {
    begun |= pressed != null && spot.distance(pressed) > STILL;
    if (!begun) {
      return;
    }
    if (isDragging(context)) {
      target = drag.target(context, vertex, pressed, spot);
      drag.preview(context, drag.places(context.viewport(), vertex, target.x(), target.y()));
    } else if (band != null) {
      band = new Band(pressed, spot);
    }
  }

  @Override
  public void released(ToolContext context, Spot spot) {
    dragged(context, spot);
    if (band != null) {
      selectInside(context, spot);
    } else if (isDragging(context)) {
      letGo(context, spot);
    }
    forget();
  }

  private void selectInside(ToolContext context, Spot spot) {
    Selection before = spot.shift() ? context.selection() : Selection.NONE;
    if (begun) {
      Points points = context.document().points();
      context.select(before.or(band.inside(points, context.viewport())));
    } else {
      context.select(before);
      context.say("There is no vertex here");
    }
  }

  private void letGo(ToolContext context, Spot spot) {
    VertexDrag ended = drag;
    drag = null;
    if (begun) {
      ended.drop(context, ended.places(context.viewport(), vertex, target.x(), target.y()));
    } else if (wasSelected) { // a click
      context.select(spot.shift() ? context.selection().toggled(vertex) : Selection.of(vertex));
    }
  }

  private void forget() {
    drag = null;
    band = null;
    target = null;
    pressed = null;
  }

  @Override
  public boolean keyPressed(ToolContext context, Key key) {
    if (context.selection().isEmpty() || drag != null) {
      return false;
    }
    if (key.isArrow()) {
      nudge.move(context, key);
      return true;
    }
    if (key.equals(Key.ESCAPE)) {
      context.select(Selection.NONE);
      return true;
    }
    return false;
  }

  @Override
  public void keysReleased(ToolContext context) {
    nudge.end(context);
  }

  @Override
  public boolean cancelled(ToolContext context) {
    nudge.end(context);
    boolean held = isDragging(context) || band != null;
    forget();
    context.endPreview();
    return held;
  }

  @Override
  public void paint(ToolContext context, Pen pen) {
    Points points = context.shown().document().points();
    if (band != null) {
      band.paint(pen);
    } else if (vertex >= 0 && vertex < points.size()) {
      Pick.mark(pen, context.viewport(), points.x(vertex), points.y(vertex));
    }
    if (target != null) {
      target.mark(pen, context.viewport());
    }
  }

  /** An undo during the drag ends it. */
  private boolean isDragging(ToolContext context) {
    if (drag != null && !drag.isOf(context.document())) {
      drag = null;
    }
    return drag != null;
  }
}
