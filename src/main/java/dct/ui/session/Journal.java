package dct.ui.session;

import dct.core.Progress;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import dct.ui.document.Origin;
import dct.ui.document.Result;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;

/**
 * Keeps on the disk what an editor holds and no file does, from each change on. Of changes that
 * follow each other faster than they are written, the newest is written. The journal is removed as
 * soon as everything is saved or given up.
 *
 * <p>A change costs the event thread no more than a comparison; a lane writes it, about as many
 * bytes as have changed, the whole document at first.
 */
public final class Journal {
  private final Editor editor;
  private final Path folder;
  private final Lane lane;
  private final Consumer<IOException> failed;
  private final AtomicReference<State> next = new AtomicReference<>(); // to be written
  private State seen = State.NOTHING; // on the event thread
  private JournalFile file; // in the lane; null while nothing is to be kept

  /** What is to be kept; nothing if the document is null. */
  private record State(Document document, String name, Optional<Origin> origin) {
    static final State NOTHING = new State(null, "", Optional.empty());

    boolean isNothing() {
      return document == null;
    }

    @SuppressWarnings("ReferenceEquality") // an equal document need not be written again, but may
    boolean isSame(State other) {
      return document == other.document && name.equals(other.name) && origin.equals(other.origin);
    }
  }

  private Journal(Editor editor, Path folder, Lane lane, Consumer<IOException> failed) {
    this.editor = editor;
    this.folder = folder;
    this.lane = lane;
    this.failed = failed;
  }

  static Journal of(Editor editor, Path folder, Lane lane, Consumer<IOException> failed) {
    Journal journal = new Journal(editor, folder, lane, failed);
    editor.addListener(journal::changed);
    return journal;
  }

  private void changed() {
    set(
        editor.history().isUnsaved()
            ? new State(editor.document(), editor.name(), editor.origin())
            : State.NOTHING);
  }

  /** Gives up what is kept, for good: the user does not want it. */
  public void end() {
    set(State.NOTHING);
  }

  private void set(State state) {
    if (!state.isSame(seen)) {
      seen = state;
      if (next.getAndSet(state) == null) {
        lane.execute(this::write);
      }
    }
  }

  private void write() {
    State state = next.getAndSet(null);
    try {
      if (state.isNothing()) {
        close();
      } else {
        write(state);
      }
      lane.setFailing(false);
    } catch (CancellationException e) {
      // a newer state is waiting, and will be written with its own result
    } catch (IOException e) {
      lane.setFailing(true);
      failed.accept(e);
    }
  }

  private void close() throws IOException {
    if (file != null) {
      JournalFile old = file;
      file = null;
      old.close();
    }
  }

  private void write(State state) throws IOException {
    if (file == null) {
      file = JournalFile.begin(folder, state.document, state.name, state.origin);
    } else if (file.isLong()) {
      JournalFile old = file;
      file = JournalFile.begin(folder, state.document, state.name, state.origin);
      old.close();
    } else {
      file.write(state.document);
    }
    Optional<Result> result = state.document.result().filter(Result::isWorthKeeping);
    if (result.isPresent()) {
      file.writeResult(state.document, result.get(), new UntilNewer());
    }
    if (next.get() == null) {
      file.force();
    }
  }

  /** Stops the writing of a result as soon as there is a newer state. */
  private final class UntilNewer implements Progress {
    @Override
    public void report(double fraction, String message) {}

    @Override
    public boolean isCancelled() {
      return next.get() != null;
    }
  }
}
