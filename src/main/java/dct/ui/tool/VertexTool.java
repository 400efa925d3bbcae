package dct.ui.tool;

import dct.core.geometry.Points;
import dct.render.Pen;

/** A tool that does something to the vertex that is clicked. */
abstract class VertexTool implements Tool {
  private int hover = -1;

  /** What a click on this vertex will do. */
  abstract String hint(ToolContext context, int vertex);

  /** What to do while no vertex is under the mouse. */
  abstract String invitation();

  /** What a click beside all vertices did not do. */
  abstract String missed();

  /** Does to the vertex what this tool is for. */
  abstract void clicked(ToolContext context, int vertex);

  @Override
  public final String hint(ToolContext context) {
    return hovers(context) ? hint(context, hover) : invitation();
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
      clicked(context, hover);
    } else {
      context.say("There is no vertex here; " + missed());
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
