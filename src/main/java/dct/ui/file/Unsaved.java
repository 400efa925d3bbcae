package dct.ui.file;

import dct.ui.document.Editor;
import dct.ui.document.History;
import java.util.ArrayList;
import java.util.List;

/** Says what of a document is not saved. */
public final class Unsaved {
  private static final String CURE = " A file whose name ends in .json keeps everything.";

  private Unsaved() {}

  /** One sentence, or two where not every file keeps it. */
  static String sentence(Editor editor) {
    History history = editor.history();
    if (history.isFileLost()) {
      return editor.name() + " is not in its file any more, which was changed or removed.";
    }
    List<String> parts = new ArrayList<>();
    if (history.isChanged() || history.isTakenBack()) {
      parts.add("changes");
    }
    if (history.hasUnsavedWishes()) {
      parts.add("wished parities");
    }
    if (history.hasUnsavedResult()) {
      parts.add("a triangulation");
    }
    String all = String.join(" and ", parts);
    String verb = all.equals("a triangulation") ? " that is" : " that are";
    return editor.name() + " has " + all + verb + " not saved." + (needsAll(editor) ? CURE : "");
  }

  /** Whether there is something that a file of points does not keep. */
  static boolean needsAll(Editor editor) {
    return editor.history().hasUnsavedWishes() || editor.history().hasUnsavedResult();
  }
}
