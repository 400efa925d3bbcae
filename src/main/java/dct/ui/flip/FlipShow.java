package dct.ui.flip;

import javax.swing.Timer;

/** Plays the flips of a view one after the other. Lives on the event thread. */
final class FlipShow {
  private static final int TICK_MILLIS = 350;
  private static final int LONGEST = 60; // ticks from the first flip to the last

  private final FlipDesk desk;
  private final Timer timer = new Timer(TICK_MILLIS, e -> tick());

  FlipShow(FlipDesk desk) {
    this.desk = desk;
  }

  /** Shows the state after so many flips, and plays no more. */
  void goTo(int index) {
    timer.stop();
    desk.replay().goTo(index);
  }

  /** Shows the state so many flips later, or earlier, and plays no more. */
  void goBy(int flips) {
    goTo(desk.replay().index() + flips);
  }

  /** Whether the flips are being played. */
  boolean isPlaying() {
    return timer.isRunning();
  }

  /** Plays from the state shown, at the end from the first; or stops. */
  void playOrStop() {
    Replay replay = desk.replay();
    if (isPlaying()) {
      timer.stop();
    } else {
      timer.start();
      replay.goTo(replay.index() == replay.size() ? 0 : replay.index());
    }
    desk.changed();
  }

  /** One flip more; several at a time where there are many. */
  private void tick() {
    Replay replay = desk.replay();
    if (replay.index() == replay.size()) {
      timer.stop();
      desk.changed();
    } else if (replay.isShown()) {
      replay.goTo(replay.index() + Math.max(1, replay.size() / LONGEST));
    }
  }
}
