package dct.ui.document;

import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** A document with the edits that led to it, and those that were taken back. */
public final class History {
  private final Deque<Edit> done = new ArrayDeque<>();
  private final Deque<Edit> undone = new ArrayDeque<>();
  private Document present;
  private Points saved;
  private ParityGoal savedWishes; // they have a file of their own

  /** A history that begins with this document, which counts as saved. */
  public History(Document start) {
    present = start;
    saved = start.points();
    savedWishes = start.wishes();
  }

  /** The document as it is now. */
  public Document present() {
    return present;
  }

  /** Applies an edit; what was undone before is forgotten. */
  public void perform(Edit edit) {
    present = edit.apply(present);
    done.push(edit);
    undone.clear();
  }

  /** Takes the last edit back, if there is one. */
  public void undo() {
    if (!done.isEmpty()) {
      Edit edit = done.pop();
      present = edit.revert(present);
      undone.push(edit);
    }
  }

  /** Applies the edit again that was taken back last, if there is one. */
  public void redo() {
    if (!undone.isEmpty()) {
      Edit edit = undone.pop();
      present = edit.apply(present);
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

  /** Says of which state the points were saved. */
  public void markSaved(Document document) {
    saved = document.points();
  }

  /** Says of which state the wishes were saved. */
  public void markWishesSaved(Document document) {
    savedWishes = document.wishes();
  }

  /** Whether the points differ from the saved ones. */
  public boolean isChanged() {
    return !present.points().equals(saved);
  }

  /** Whether there are wishes that would be lost with the document. */
  public boolean hasUnsavedWishes() {
    return !present.wishes().isAll(Wish.EVEN) && !present.wishes().equals(savedWishes);
  }
}
