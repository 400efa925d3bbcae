package dct.ui.document;

import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** A document with the edits that led to it, and those that were taken back. */
public final class History {
  private final Document start;
  private final Deque<Step> done = new ArrayDeque<>(); // the last first
  private final Deque<Step> undone = new ArrayDeque<>();
  private Document present;
  private Optional<Document> saved; // whose points a file holds; nothing if none does
  private ParityGoal savedWishes; // they have a file of their own
  private Optional<Result> savedResult;
  private Optional<Document> whole; // what the file holds, if it keeps everything
  private boolean isFileLost; // the file no longer holds what was saved

  /**
   * An edit that was made.
   *
   * @param before the result at the time, which the edit may have dropped
   */
  private record Step(Edit edit, Optional<Result> before) {}

  /** A history that begins with this document, which counts as saved. */
  public History(Document start) {
    this.start = start;
    present = start;
    markWholeSaved(start);
  }

  /** A history that begins with this document, which no file holds. */
  static History unsaved(Document start) {
    History history = new History(start);
    history.saved = Optional.empty();
    history.savedWishes = ParityGoal.allEven(start.size());
    history.savedResult = Optional.empty();
    history.whole = Optional.empty();
    return history;
  }

  /** The document as it is now. */
  public Document present() {
    return present;
  }

  /** Applies an edit; what was undone before is forgotten. */
  public void perform(Edit edit) {
    apply(edit);
    undone.clear();
  }

  private void apply(Edit edit) {
    done.push(new Step(edit, present.result()));
    present = edit.apply(present);
  }

  /** Takes the last edit back, if there is one. */
  public void undo() {
    if (!done.isEmpty()) {
      Step step = done.pop();
      present = step.edit.revert(present).with(step.before);
      undone.push(step);
    }
  }

  /** Applies the edit again that was taken back last, if there is one. */
  public void redo() {
    if (!undone.isEmpty()) {
      apply(undone.pop().edit);
    }
  }

  /** The edit that {@link #undo} would take back. */
  public Optional<Edit> lastDone() {
    return Optional.ofNullable(done.peek()).map(Step::edit);
  }

  /** The edit that {@link #redo} would apply. */
  public Optional<Edit> lastUndone() {
    return Optional.ofNullable(undone.peek()).map(Step::edit);
  }

  /** The name of the edit that {@link #undo} would take back. */
  public Optional<String> undoLabel() {
    return lastDone().map(Edit::label);
  }

  /** The name of the edit that {@link #redo} would apply. */
  public Optional<String> redoLabel() {
    return lastUndone().map(Edit::label);
  }

  /**
   * The result that each view showed last, by the number of the view; also of points that have
   * changed since.
   */
  public Map<Integer, Result> results() {
    Map<Integer, Result> latest = new TreeMap<>();
    made().forEach(result -> latest.put(result.view(), result));
    present.result().ifPresent(result -> latest.put(result.view(), result));
    return latest;
  }

  /** All results that steps have made, from the oldest on; also of points that have changed. */
  public List<Result> made() {
    List<Result> all = new ArrayList<>();
    start.result().ifPresent(all::add);
    List<Step> steps = new ArrayList<>(done);
    Collections.reverse(steps);
    for (Step step : steps) {
      if (step.edit instanceof Edit.Made made) {
        made.after().ifPresent(all::add);
      }
    }
    return all;
  }

  /** The step that made the present result, if it was made here and is as it was made. */
  public Optional<Edit.Made> making() {
    return done.stream()
        .map(Step::edit)
        .filter(Edit.Made.class::isInstance)
        .map(Edit.Made.class::cast)
        .findFirst()
        .filter(made -> made.after().isPresent() && made.after().equals(present.result()));
  }

  /** Says of which state the points were saved. */
  public void markSaved(Document document) {
    isFileLost = false;
    saved = Optional.of(document.with(Optional.empty()));
    whole = Optional.empty();
  }

  /** Says of which state the wishes were saved. */
  public void markWishesSaved(Document document) {
    savedWishes = document.wishes();
  }

  /** Says of which state everything was saved: points, wishes and result. */
  public void markWholeSaved(Document document) {
    markSaved(document);
    markWishesSaved(document);
    savedResult = document.result();
    whole = Optional.of(document);
  }

  /** Says whether the file no longer holds what was saved there. */
  public void setFileLost(boolean lost) {
    isFileLost = lost;
  }

  /** Whether the file no longer holds what was saved there. */
  public boolean isFileLost() {
    return isFileLost;
  }

  /** Whether anything would be lost with the document, or its file holds what it has no longer. */
  public boolean isUnsaved() {
    return isFileLost || isChanged() || hasUnsavedWishes() || hasUnsavedResult() || isTakenBack();
  }

  /** Whether the points, or how they hang together, differ from the saved ones. */
  public boolean isChanged() {
    return saved.map(Document::settled).filter(present.settled()::isDrawnAs).isEmpty();
  }

  /** Whether there are wishes that would be lost with the document. */
  public boolean hasUnsavedWishes() {
    return hasWishes(present) && !present.wishes().equals(savedWishes);
  }

  /** Whether there are flips or an optimum that would be lost with the document. */
  public boolean hasUnsavedResult() {
    return keepsResult(present) && !present.result().equals(savedResult);
  }

  /** Whether the file still holds wishes, flips or an optimum, and the document none. */
  public boolean isTakenBack() {
    return whole
        .filter(
            file ->
                (hasWishes(file) && !hasWishes(present))
                    || (keepsResult(file) && !keepsResult(present)))
        .isPresent();
  }

  private static boolean hasWishes(Document document) {
    return !document.wishes().isAll(Wish.EVEN);
  }

  private static boolean keepsResult(Document document) {
    return document.result().filter(Result::isWorthKeeping).isPresent();
  }
}
