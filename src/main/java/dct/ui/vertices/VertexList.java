package dct.ui.vertices;

import dct.core.triangulate.Triangulation;
import dct.ui.document.Document;
import dct.ui.document.Selection;
import dct.ui.tool.ToolContext;
import java.util.Optional;
import javax.swing.JScrollPane;
import javax.swing.Timer;

/**
 * The tab with the table of the vertices. It follows the document, a few times a second at most.
 */
public final class VertexList extends JScrollPane {
  private static final long serialVersionUID = 1L;
  private static final int PAUSE_MILLIS = 40;

  private final VertexTable table;
  private final Timer pause = new Timer(PAUSE_MILLIS, e -> write());
  private transient Document document;
  private transient Selection selection = Selection.NONE;
  private transient Optional<Triangulation> triangulation = Optional.empty();

  /** An empty table; the context performs what is typed. */
  public VertexList(ToolContext context) {
    table = new VertexTable(new VertexRows(context), context);
    pause.setRepeats(false);
    setViewportView(table);
  }

  /**
   * Shows this document.
   *
   * @param made the triangulation whose degrees are shown, if there is any
   * @param chosen the vertices that are selected
   */
  public void show(Document shown, Optional<Triangulation> made, Selection chosen) {
    boolean other = document == null || shown.domain() != document.domain();
    document = shown;
    triangulation = made;
    selection = chosen;
    if (other) {
      write();
    } else if (!pause.isRunning()) {
      pause.start();
    }
  }

  private void write() {
    table.show(document, triangulation, selection);
  }
}
