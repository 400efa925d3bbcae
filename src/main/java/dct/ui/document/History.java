package dct.ui.document;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** A document with the edits that led to it, and those that were taken back. */
public final class History {
  private final Deque<Edit> done = new ArrayDeque<>();
  private final Deque<Edit> undone = new ArrayDeque<>();
  private Document present;
  private Document saved;

  /** A history that begins with this document, which counts as saved. */
  public History(Document start) {
    present = start;
    saved = start;
  }

  /** The document as it is now. */
  public Document present() {
    return present;
  }

  /** Applies an edit; what was undone before is forgotten. */
  public void perform(Edit edit) {
    present = present.with(edit.apply(present.points()));
    done.push(edit);
    undone.clear();
  }

  /** Takes the last edit back, if there is one. */
  public void undo() {
    if (!done.isEmpty()) {
      Edit edit = done.pop();
      present = present.with(edit.revert(present.points()));
      undone.push(edit);
    }
  }

  /** Applies the edit again that was taken back last, if there is one. */
  public void redo() {
    if (!undone.isEmpty()) {
      Edit edit = undone.pop();
      present = present.with(edit.apply(present.points()));
      done.push(edit);
    }
  }

  /** The name of the edit that {@link #undo} would take back. */
  public Optional<String> undoLabel() {
    return Optional.ofNullable(done.peek()).map(Edit::label);
  }

  /** The name of the edit that {@link #redo} would apply. */
  public Optional<String> redoLabel() {
    return Optional.ofNullable(undone.peek()).map(Edit::label);
  }

  /** Says which state was saved. */
  public void markSaved(Document document) {
    saved = document;
  }

  /** Whether the present document differs from the saved one. */
  public boolean isChanged() {
    return !present.equals(saved);
  }
}
