package dct.ui.tool;

import dct.ui.document.Edit;
import java.awt.event.KeyEvent;

/** Delete Vertex: a click on a vertex removes it, and joins its neighbours. */
public final class DeleteTool extends VertexTool {

  @Override
  public String name() {
    return "Delete Vertex";
  }

  @Override
  public String description() {
    return "A click removes a vertex";
  }

  @Override
  public int key() {
    return KeyEvent.VK_X;
  }

  @Override
  String hint(ToolContext context, int vertex) {
    return "Click to delete v" + vertex;
  }

  @Override
  String invitation() {
    return "Click a vertex to delete it";
  }

  @Override
  String missed() {
    return "nothing was deleted";
  }

  @Override
  void clicked(ToolContext context, int vertex) {
    context.perform(Edit.delete(context.document(), vertex));
    left(context); // the number is another vertex' now
  }
}
