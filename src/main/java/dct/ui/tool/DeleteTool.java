package dct.ui.tool;

import dct.core.geometry.Points;
import dct.render.Pen;
import dct.ui.document.Edit;
import java.awt.event.KeyEvent;

/** Delete Vertex: a click on a vertex removes it, and joins its neighbours. */
public final class DeleteTool implements Tool {
  private int hover = -1;

  @Override
  public String name() {
    return "Delete Vertex";
  }

  @Override
  public int key() {
    return KeyEvent.VK_X;
  }

  @Override
  public String hint(ToolContext context) {
    return hovers(context) ? "Click to delete v" + hover : "Click a vertex to delete it";
  }

  @Override
  public void moved(ToolContext context, Spot spot) {
    hover = Pick.vertex(context.document().points(), context.viewport(), spot);
  }

  @Override
  public void left(ToolContext context) {
    hover = -1;
  }

  @Override
  public void pressed(ToolContext context, Spot spot) {
    moved(context, spot);
    if (hovers(context)) {
      context.perform(Edit.delete(context.document(), hover));
      hover = -1;
    } else {
      context.say("There is no vertex here; nothing was deleted");
    }
  }

  @Override
  public void paint(ToolContext context, Pen pen) {
    if (hovers(context)) {
      Points points = context.document().points();
      Pick.mark(pen, context.viewport(), points.x(hover), points.y(hover));
    }
  }

  /** An undo may have taken away the vertex that the mouse was over. */
  private boolean hovers(ToolContext context) {
    return hover >= 0 && hover < context.document().size();
  }
}
