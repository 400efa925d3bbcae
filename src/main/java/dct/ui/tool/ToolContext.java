package dct.ui.tool;

import dct.core.geometry.Points;
import dct.render.Viewport;
import dct.ui.document.Analysis;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Selection;

/** All that a tool may know and do. */
public interface ToolContext {

  /** The document, without what is only provisional. */
  Document document();

  /** What is shown of it. */
  Analysis shown();

  /** Where the model is on the screen. */
  Viewport viewport();

  /** Applies an edit. */
  void perform(Edit edit);

  /** Shows these points in place of the document's, until an edit or {@link #endPreview}. */
  void preview(Points points);

  /** Goes back to the document's points. */
  void endPreview();

  /** The vertices that are selected; none where nothing can be. */
  default Selection selection() {
    return Selection.NONE;
  }

  /** Selects other vertices, where that can be done. */
  default void select(Selection others) {}

  /** What places snap to; nothing unless the user has set it. */
  default Snap snap() {
    return new Snap(() -> {});
  }

  /** Chooses Edit Vertex. */
  void chooseEdit();

  /** Tells the user something in the status line. */
  void say(String message);
}
