package dct.ui.tool;

import dct.core.triangulate.Triangulation;

/**
 * What a flip by hand came to: to be told while what it made is shown, neither undone nor followed
 * by another step, and while the mouse stays where it was.
 */
final class FlipNews {
  /** A mouse that moves less, in pixels, is still where it was. */
  private static final double STILL = 6;

  private final String text;
  private final Spot at;
  private final Triangulation before;
  private Triangulation after; // null until it is shown: a flip of many vertices takes a while

  /** News of a flip at this place, of the triangulation that is shown before it. */
  FlipNews(String text, Spot at, Triangulation before) {
    this.text = text;
    this.at = at;
    this.before = before;
  }

  String text() {
    return text;
  }

  /** Whether it is what made this triangulation; the first other one that is shown is taken so. */
  boolean isOf(Triangulation shown) {
    if (after == null && shown != before) {
      after = shown;
    }
    return shown == after;
  }

  /** Whether the mouse has not gone elsewhere. */
  boolean isAt(Spot mouse) {
    return Math.hypot(mouse.screenX() - at.screenX(), mouse.screenY() - at.screenY()) <= STILL;
  }
}
