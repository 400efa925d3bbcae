package dct.ui.flip;

import dct.core.degree.Flip;
import dct.core.degree.FlipPlayer;
import dct.core.degree.FlipResult;
import dct.problem.Solution;
import dct.render.Scene;
import dct.ui.document.Result;
import dct.ui.job.Jobs;
import java.util.Optional;

/**
 * The flips of a result, played forwards and backwards. Going to a state takes as many steps as
 * flips lie between, its picture linear time: that of large ones is made in the background, of many
 * that follow each other quickly the newest. Lives on the event thread.
 */
final class Replay {
  /** So many vertices are shown within a frame of the screen. */
  private static final int AT_ONCE = 3_000;

  private final Optional<Result> result;
  private final Optional<FlipResult> flips;
  private final Jobs jobs;
  private final Runnable whenShown;
  private FlipPlayer player; // made when it is first needed
  private Optional<Result> shown;
  private int index; // of the state wished
  private int shownIndex;
  private boolean begun; // any state was asked for
  private boolean working; // in the background
  private boolean stopped;

  /**
   * The flips of a result, at their end.
   *
   * @param whenShown is run when another state is shown
   */
  Replay(Optional<Result> result, Jobs jobs, Runnable whenShown) {
    this.result = result;
    this.jobs = jobs;
    this.whenShown = whenShown;
    flips = result.flatMap(r -> r.solution().flips());
    shown = result;
    index = size();
    shownIndex = index;
  }

  /** What was flipped, if anything was. */
  Optional<FlipResult> flips() {
    return flips;
  }

  /** The number of flips. */
  int size() {
    return flips.map(FlipResult::flips).orElse(0);
  }

  /** How many flips are carried out in the state asked for last. */
  int index() {
    return index;
  }

  /** Whether all flips are carried out: the result itself is shown. */
  boolean isAtEnd() {
    return shownIndex == size();
  }

  /** Whether the state asked for last is the one that is shown. */
  boolean isShown() {
    return shownIndex == index;
  }

  /** The state that is shown. */
  Optional<Result> shown() {
    return shown;
  }

  /** Shows the state after so many flips; of what is out of range the nearest. */
  void goTo(int wished) {
    int within = Math.max(0, Math.min(size(), wished));
    if (within != index || !begun) {
      begun = size() > 0;
      index = within;
      show();
    }
  }

  /** The flip that led to the state shown, once any state was asked for. */
  Optional<Flip> last() {
    if (!begun || shownIndex == 0) {
      return Optional.empty();
    }
    int edge = flips.orElseThrow().edges().get(shownIndex - 1);
    return Flip.at(shown.orElseThrow().solution().triangulation(), edge).map(Flip::inverse);
  }

  private void show() {
    if (result.isEmpty()) {
      return;
    }
    if (index == size() && !working) {
      take(result.get(), index);
    } else if (result.get().solution().instance().size() <= AT_ONCE) {
      take(state(index), index);
    } else if (!working) {
      working = true;
      int wanted = index;
      jobs.update("Playing the flips", progress -> state(wanted), made -> end(made, wanted));
    }
  }

  private Result state(int at) {
    Result of = result.orElseThrow();
    if (at == size()) {
      return of;
    }
    if (player == null) {
      player = new FlipPlayer(flips.orElseThrow());
    }
    player.goTo(at);
    Solution solution = of.solution().withFlips(player.result());
    Scene scene = Scene.of(solution).withWishes(solution.instance().wishes()).prepared();
    return new Result(of.view(), of.title(), solution, scene, Optional.empty());
  }

  private void end(Result made, int at) {
    working = false;
    if (!stopped) {
      take(made, at);
      if (at != index) {
        show();
      }
    }
  }

  private void take(Result state, int at) {
    shown = Optional.of(state);
    shownIndex = at;
    whenShown.run();
  }

  /** Shows nothing more. */
  void stop() {
    stopped = true;
  }
}
