package dct.ui.flip;

import dct.core.degree.Flip;
import dct.problem.Solution;
import dct.render.Scene;
import dct.ui.document.Document;
import dct.ui.document.Result;
import dct.ui.job.Jobs;
import dct.ui.tool.FlipHost;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * The flips of one view: what is flipped by hand becomes a step of the history, and what was
 * flipped is played forwards and backwards. Lives on the event thread.
 */
public final class FlipDesk implements FlipHost {
  /** Up to so many vertices a flip takes a few milliseconds; beyond, it is made in a job. */
  static final int AT_ONCE = 10_000;

  private final FlipSource source;
  private final Jobs jobs;
  private final Consumer<String> status;
  private final List<Runnable> listeners = new ArrayList<>();
  private Optional<Result> given = Optional.empty(); // by the source
  private Replay replay;

  /**
   * The flips of a view.
   *
   * @param jobs make flips of what is large
   * @param status takes messages for the status line
   */
  public FlipDesk(FlipSource source, Jobs jobs, Consumer<String> status) {
    this.source = source;
    this.jobs = jobs;
    this.status = status;
    replay = new Replay(Optional.empty(), jobs, this::changed);
  }

  /** Calls the listener after each change of what is shown. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** Tells the listeners. */
  void changed() {
    listeners.forEach(Runnable::run);
  }

  /** Brings everything up to date with the source: other flips are shown at their end. */
  public void refresh() {
    Optional<Result> now = source.result();
    if (!now.map(Result::scene).equals(given.map(Result::scene))) {
      given = now;
      replay.stop();
      replay = new Replay(now, jobs, this::changed);
      changed();
    }
  }

  /** The flips of what is shown, and how many of them are carried out. */
  Replay replay() {
    return replay;
  }

  /** What the view shows, if it can be flipped: the result, or a state on the way to it. */
  Optional<Result> shown() {
    return replay.shown();
  }

  /** The picture of a state on the way to the result, while one is shown. */
  public Optional<Scene> onTheWay() {
    return replay.isAtEnd() ? Optional.empty() : shown().map(Result::scene);
  }

  @Override
  public Optional<Solution> solution() {
    refresh();
    return shown().map(Result::solution);
  }

  @Override
  public Scene scene() {
    return shown().orElseThrow().scene();
  }

  @Override
  public String refusal() {
    return source.refusal();
  }

  @Override
  public String verdict() {
    return shown()
        .map(Result::solution)
        .filter(Solution::isProven)
        .map(Solution::verdict)
        .orElse("");
  }

  @Override
  public void flip(int edge) {
    Solution solution = shown().orElseThrow().solution();
    String label = "Flip " + Flip.at(solution.triangulation(), edge).orElseThrow().removed();
    perform(label, before -> before.flippedAt(edge));
  }

  /** Makes a state on the way to the result the present one. */
  void goOnFromHere() {
    if (!replay.isAtEnd()) {
      perform("Go On from Flip " + replay.index(), before -> before);
    }
  }

  /** Makes a step of the history of what becomes of the solution shown. */
  public void perform(String label, Function<Solution, Solution> change) {
    Result before = shown().orElseThrow();
    Document document = source.editor().document();
    if (before.solution().instance().size() <= AT_ONCE) {
      accept(label, document, after(before, change));
    } else {
      jobs.submit(label, progress -> after(before, change), made -> accept(label, document, made));
    }
  }

  private static Result after(Result before, Function<Solution, Solution> change) {
    Result made = Result.of(before.view(), before.title(), change.apply(before.solution()));
    made.scene().prepared();
    return made;
  }

  private void accept(String label, Document of, Result result) {
    if (!source.editor().accept(label, of, result)) {
      status.accept(label + " is left out: the vertices have changed meanwhile");
    }
  }

  Jobs jobs() {
    return jobs;
  }

  /** Tells the user something in the status line. */
  public void say(String message) {
    status.accept(message);
  }

  /** What the document is called. */
  public String documentName() {
    return source.editor().name();
  }
}
