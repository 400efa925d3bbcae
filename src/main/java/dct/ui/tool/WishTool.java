package dct.ui.tool;

import dct.core.degree.ParityGoal.Wish;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import java.awt.Cursor;
import java.awt.event.KeyEvent;
import java.util.Locale;

/** Wish Parity: a click on a vertex changes what is wished of its degree: even, odd, any. */
public final class WishTool extends VertexTool {

  @Override
  public String name() {
    return "Wish Parity";
  }

  @Override
  public String description() {
    return "A click changes the parity wished of a vertex: even, odd, any";
  }

  @Override
  public int key() {
    return KeyEvent.VK_W;
  }

  @Override
  public Cursor cursor() {
    return Cursor.getPredefinedCursor(Cursor.HAND_CURSOR);
  }

  @Override
  String hint(ToolContext context, int vertex) {
    Wish wish = context.document().wishes().wish(vertex);
    return String.format(
        Locale.ROOT, "v%d is wished %s; click to wish it %s", vertex, word(wish), word(next(wish)));
  }

  @Override
  String invitation() {
    return "Click a vertex to change the parity that is wished of it: even, odd, any";
  }

  @Override
  String missed() {
    return "no wish was changed";
  }

  @Override
  void clicked(ToolContext context, int vertex) {
    Document document = context.document();
    context.perform(Edit.wish(document, vertex, next(document.wishes().wish(vertex))));
  }

  private static Wish next(Wish wish) {
    return switch (wish) {
      case EVEN -> Wish.ODD;
      case ODD -> Wish.ANY;
      case ANY -> Wish.EVEN;
    };
  }

  private static String word(Wish wish) {
    return wish.name().toLowerCase(Locale.ROOT);
  }
}
