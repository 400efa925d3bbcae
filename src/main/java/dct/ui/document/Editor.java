package dct.ui.document;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.ui.job.Jobs;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * One application's document as it is edited: its history, its file, a provisional state while the
 * mouse drags, and the analysis that follows each of them. Lives on the event thread.
 */
public final class Editor {
  /**
   * Up to here a document is analysed at once, within a frame of the screen; beyond, in the
   * background, so that the window never waits.
   */
  static final int AT_ONCE = 2_000;

  private final Jobs jobs;
  private final Domain domain;
  private final List<Runnable> listeners = new ArrayList<>();
  private History history;
  private String name;
  private Optional<Origin> origin = Optional.empty();
  private Optional<Path> wishFile = Optional.empty(); // saved to or read from last
  private Document wishesInFile; // the state whose wishes it holds
  private Document provisional; // while a drag lasts, else null
  private Analysis shown;
  private final LivePicture live = new LivePicture(); // of large sets of sites
  private boolean growing;
  private Optional<LiveMethod> method = Optional.empty(); // of the live triangulation
  private final LivePace pace = new LivePace();
  private Optional<Jobs.Handle> analysis = Optional.empty(); // queued last
  private Selection selection = Selection.NONE;
  private Points selected = Points.ofPairs(); // the points that the selection is of
  private int changes; // of the document; analyses from before the last one are not shown

  /** An editor of an empty document. */
  public Editor(Domain domain, Jobs jobs) {
    this.domain = domain;
    this.jobs = jobs;
    startAnew();
  }

  /** Calls the listener after each change of anything here. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** Which of the two applications this is. */
  public Domain domain() {
    return domain;
  }

  /** The document, without what is only provisional. */
  public Document document() {
    return history.present();
  }

  /** The history of the document. */
  public History history() {
    return history;
  }

  /** The document as the screen should show it. */
  public Document visible() {
    return provisional == null ? document() : provisional;
  }

  /** The latest analysis; of an older state while a newer one is computed. */
  public Analysis shown() {
    return shown;
  }

  /** The vertices that are selected; they follow the changes of the document. */
  public Selection selection() {
    return selection;
  }

  /** Selects other vertices. */
  public void select(Selection others) {
    if (!others.equals(selection)) {
      selection = others;
      changed();
    }
  }

  /** What the title calls the document. */
  public String name() {
    return name;
  }

  /** The file that the document was opened from or saved to. */
  public Optional<Origin> origin() {
    return origin;
  }

  /** Begins an empty document without a file. */
  public void startAnew() {
    load(Document.empty(domain), "New " + domain.title());
  }

  /** Begins with this document, which has no file, its history empty. */
  public void load(Document document, String newName) {
    load(document, newName, Optional.empty());
  }

  /** Begins with this document, its history empty. */
  public void load(Document document, String newName, Optional<Origin> from) {
    begin(new History(document), newName, from);
  }

  /** Begins with this document, which no file holds any more or yet, its history empty. */
  public void recover(Document document, String newName, Optional<Origin> from) {
    begin(History.unsaved(document), newName, from);
  }

  private void begin(History anew, String newName, Optional<Origin> from) {
    history = anew;
    name = newName;
    origin = from;
    provisional = null;
    shown = Analysis.pending(document(), growing);
    live.forget();
    analyse();
  }

  /** Says that the points of a state of the document are what this file holds. */
  public void saved(Document document, Origin to) {
    history.markSaved(document);
    isIn(to);
  }

  /** Says that this file holds all of a state of the document: also its wishes and its result. */
  public void wholeSaved(Document document, Origin to) {
    history.markWholeSaved(document);
    isIn(to);
  }

  private void isIn(Origin file) {
    origin = Optional.of(file);
    name = file.name();
    changed();
  }

  /** Says whether the file no longer holds the document that it is from. */
  public void setFileLost(boolean lost) {
    if (lost != history.isFileLost()) {
      history.setFileLost(lost);
      changed();
    }
  }

  /** Takes over what the file holds now, as a step that can be undone. */
  public void reloaded(Document document, Origin from) {
    perform(new Edit.Replace("Reload", document(), document));
    wholeSaved(document, from);
  }

  /** Applies an edit. */
  public void perform(Edit edit) {
    provisional = null;
    history.perform(edit);
    analyse();
  }

  /** Takes the last edit back. */
  public void undo() {
    provisional = null;
    history.undo();
    analyse();
  }

  /** Applies the edit again that was taken back last. */
  public void redo() {
    provisional = null;
    history.redo();
    analyse();
  }

  /** The file that holds the wishes as they are, if there is one. */
  public Optional<Path> wishFile() {
    return wishFile.filter(held -> wishesInFile.wishes().equals(document().wishes()));
  }

  /** Says that a state's wishes are in a file of their own now. */
  public void wishesSaved(Document document, Path newFile) {
    wishFile = Optional.of(newFile);
    wishesInFile = document;
    wishesSaved(document);
  }

  /** Says that a state's wishes are in a file now. */
  public void wishesSaved(Document document) {
    history.markWishesSaved(document);
    changed();
  }

  /**
   * Shows the document with its vertices at these places. Where one site of many has moved, only
   * the picture follows. Else, of many that follow each other quickly, the newest is analysed
   * whenever the one before is done, so that the picture keeps moving.
   */
  public void preview(Points points) {
    provisional = document().with(points);
    analysis.ifPresent(Jobs.Handle::withdraw);
    analyseVisible();
  }

  /** Goes back to the document's points. */
  public void endPreview() {
    if (provisional != null) {
      provisional = null;
      analyse();
    }
  }

  /** Whether vertices are being drawn. */
  public void setGrowing(boolean growing) {
    this.growing = growing;
    shown = shown.growing(growing);
    changed();
  }

  /** By what a simple polygon is triangulated whenever it changes, if by anything. */
  public Optional<LiveMethod> live() {
    return method;
  }

  /** Says by what a simple polygon is triangulated whenever it changes. */
  public void setLive(Optional<LiveMethod> chosen) {
    method = chosen;
    analyse();
  }

  private Manner manner() {
    return new Manner(growing, method, provisional != null);
  }

  /**
   * Takes over what was made of a document, as a named step, unless the document has changed since.
   *
   * @return whether it was taken over
   */
  public boolean accept(String label, Document of, Result result) {
    boolean same = document().equals(of);
    if (same) {
      perform(Edit.result(label, of, Optional.of(result)));
    }
    return same;
  }

  private void followPoints() {
    Points now = document().points();
    selection = selection.following(selected, now);
    selected = now;
  }

  private void analyse() {
    followPoints();
    changes++;
    analysis.ifPresent(Jobs.Handle::cancel);
    analyseVisible();
  }

  private void analyseVisible() {
    Document document = visible();
    Manner manner = manner();
    if (shown.isOf(document, manner)) {
      show(shown.with(document));
    } else if (document.size() <= AT_ONCE && pace.isQuick(manner, document.size())) {
      show(pace.measured(document, manner, Progress.NONE));
    } else {
      Optional<Analysis> picture = domain == Domain.SITES ? live.of(document) : Optional.empty();
      if (picture.isEmpty() || (provisional == null && !picture.get().isWhole())) {
        analyseInBackground(document);
      } else {
        analysis.ifPresent(Jobs.Handle::cancel); // it is of an older state
      }
      picture.ifPresentOrElse(this::show, () -> showMeanwhile(document));
    }
  }

  private void analyseInBackground(Document document) {
    int change = changes;
    Manner manner = manner();
    analysis =
        Optional.of(
            jobs.update(
                "Analysing the " + domain.title(),
                progress -> pace.measured(document, manner, progress),
                result -> showUnlessChanged(result, change)));
  }

  /** After a small change the picture of the old state is the better one to look at meanwhile. */
  private void showMeanwhile(Document document) {
    if (Math.abs(shown.document().size() - document.size()) > 1) {
      shown = Analysis.pending(document, growing);
      live.forget();
    }
    changed();
  }

  private void showUnlessChanged(Analysis result, int change) {
    if (change == changes) {
      show(result);
    }
  }

  private void show(Analysis result) {
    shown = result.growing(growing);
    live.note(shown);
    changed();
  }

  private void changed() {
    listeners.forEach(Runnable::run);
  }
}
