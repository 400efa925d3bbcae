package dct.ui.solve;

import dct.core.Progress;
import dct.core.degree.FlipList;
import dct.io.CannotWriteException;
import dct.io.FlipFile;
import dct.problem.Solution;
import dct.ui.dialog.Ask;
import dct.ui.dialog.Chooser;
import dct.ui.flip.FlipCommands;
import dct.ui.flip.FlipDesk;
import dct.ui.job.Jobs;
import java.awt.Component;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;

/** Lists of flips of a view: to and from files and the clipboard. */
public final class FlipListWork implements FlipCommands.Lists {
  private static final String APPLY = "Apply Flips";

  private final Component parent;
  private final FlipDesk desk;
  private final Jobs jobs;
  private final Supplier<Optional<Path>> folder;

  /** What came of carrying a list out, and the list. */
  private record Outcome(FlipFile file, FlipList.Applied applied) {}

  /**
   * Lists of flips of a view.
   *
   * @param folder where the document's file is
   */
  public FlipListWork(Component parent, FlipDesk desk, Jobs jobs, Supplier<Optional<Path>> folder) {
    this.parent = parent;
    this.desk = desk;
    this.jobs = jobs;
    this.folder = folder;
  }

  private Optional<FlipList> list() {
    return desk.solution().flatMap(Solution::flips).map(FlipList::of);
  }

  @Override
  public void save() {
    String name = desk.documentName().replaceFirst("\\.[^.]*$", "") + "_flips.txt";
    Path suggested = folder.get().map(f -> f.resolve(name)).orElse(Path.of(name));
    Optional<Path> typed = Chooser.FLIPS.save(parent, suggested, "Save Flips");
    if (typed.isPresent()
        && (!Files.exists(typed.get()) || Chooser.confirmReplacing(parent, typed.get()))) {
      list().ifPresent(flips -> save(flips, typed.get()));
    }
  }

  private void save(FlipList flips, Path file) {
    jobs.write(
        "Saving " + file.getFileName(),
        progress -> write(file, flips, progress),
        written -> desk.say("Saved " + written));
  }

  private static Path write(Path file, FlipList flips, Progress progress) {
    try {
      FlipFile.write(file, flips, progress);
      return file;
    } catch (CannotWriteException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void load() {
    Optional<Path> file = Chooser.FLIPS.open(parent, folder.get(), "Load Flips");
    Optional<Solution> to = desk.solution();
    if (file.isPresent() && to.isPresent()) {
      int n = to.get().instance().size();
      apply(progress -> FlipFile.read(file.get(), n, progress));
    }
  }

  @Override
  public void copy() {
    list()
        .ifPresent(
            flips -> {
              clipboard().setContents(new StringSelection(FlipFile.text(flips)), null);
              desk.say(
                  String.format(
                      Locale.ROOT,
                      "%d %s copied; Apply Copied Flips carries them out in another triangulation"
                          + " of the same points",
                      flips.size(),
                      flips.size() == 1 ? "flip" : "flips"));
            });
  }

  private Clipboard clipboard() {
    return parent.getToolkit().getSystemClipboard();
  }

  @Override
  public void apply() {
    Optional<Solution> to = desk.solution();
    Optional<String> text = text();
    if (text.isEmpty()) {
      desk.say("There is no list of flips in the clipboard; choose Copy Flips first");
    } else if (to.isPresent()) {
      int n = to.get().instance().size();
      apply(progress -> parsed(text.get(), n));
    }
  }

  private Optional<String> text() {
    try {
      return clipboard().isDataFlavorAvailable(DataFlavor.stringFlavor)
          ? Optional.of((String) clipboard().getData(DataFlavor.stringFlavor))
          : Optional.empty();
    } catch (UnsupportedFlavorException | IOException | IllegalStateException e) {
      return Optional.empty(); // another program has it just now
    }
  }

  private static FlipFile parsed(String text, int n) {
    try {
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
      return FlipFile.read("clipboard", new ByteArrayInputStream(bytes), n);
    } catch (IOException e) {
      throw new UncheckedIOException(e); // no disk is read
    }
  }

  /** Carries out what is read, in the triangulation that is shown. */
  private void apply(Function<Progress, FlipFile> read) {
    Solution to = desk.solution().orElseThrow();
    jobs.read(
        APPLY,
        progress -> {
          FlipFile file = read.apply(progress);
          return new Outcome(file, file.list().applyTo(to.triangulation(), progress));
        },
        outcome -> applied(to, outcome));
  }

  private void applied(Solution to, Outcome outcome) {
    if (outcome.applied.cause().isEmpty()) {
      take(to, outcome);
    } else {
      // A dialog waits for its answer; the queue of jobs must not wait with it.
      SwingUtilities.invokeLater(() -> refused(to, outcome));
    }
  }

  private void refused(Solution to, Outcome outcome) {
    String sentence = outcome.file.refusal(outcome.applied);
    int possible = outcome.applied.result().flips();
    if (possible == 0) {
      Ask.sorry(parent, APPLY, sentence);
    } else if (Ask.choose(parent, APPLY, sentence, 0, "Keep " + possible, "Cancel") == 0) {
      take(to, outcome);
    }
  }

  private void take(Solution to, Outcome outcome) {
    boolean same =
        desk.solution().filter(now -> now.triangulation() == to.triangulation()).isPresent();
    if (same) {
      desk.perform(APPLY, before -> before.flipped(outcome.applied.result()));
    } else {
      desk.say("The triangulation has changed meanwhile; no flip was carried out");
    }
  }
}
