package dct.ui.canvas;

import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Toolkit;

/**
 * Counts clicks that follow each other so quickly, and so near to each other, that they are meant
 * as a double click although the hand was not quite still.
 */
final class Clicks {
  /** How far the second click of a double click may be, in pixels. */
  static final int REACH = 4;

  private static final int USUAL_MILLIS = 500;

  private final long interval;
  private Point place = new Point();
  private long time;
  private int count;

  /** Counts in the time that the user has set for the desktop. */
  Clicks() {
    this(desktopInterval());
  }

  Clicks(long intervalMillis) {
    interval = intervalMillis;
  }

  private static long desktopInterval() {
    Object set =
        GraphicsEnvironment.isHeadless()
            ? null
            : Toolkit.getDefaultToolkit().getDesktopProperty("awt.multiClickInterval");
    return set instanceof Integer millis ? millis : USUAL_MILLIS;
  }

  /** Which click in a row this one is, from 1 on. */
  int count(long millis, Point at) {
    boolean again = count > 0 && millis - time <= interval && at.distance(place) <= REACH;
    count = again ? count + 1 : 1;
    time = millis;
    place = at;
    return count;
  }
}
