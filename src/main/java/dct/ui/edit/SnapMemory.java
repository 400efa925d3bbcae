package dct.ui.edit;

import dct.ui.session.Settings;
import dct.ui.tool.Snap;
import java.util.Locale;

/** What places snap to, from one run of the program to the next. */
final class SnapMemory {
  private static final String GRID = "snap.grid.size";
  private static final String ANGLE = "snap.angle.degrees";

  private SnapMemory() {}

  /** Sets what the settings were told last; a number that cannot be is left out. */
  static void restore(Snap snap, Settings settings) {
    settings.decimal(GRID).ifPresent(size -> attempt(() -> snap.setGrid(size)));
    settings.decimal(ANGLE).ifPresent(degrees -> attempt(() -> snap.setAngle(degrees)));
    for (Snap.To to : Snap.To.values()) {
      if (settings.isOn(name(to)) != snap.isOn(to)) {
        snap.toggle(to);
      }
    }
  }

  private static void attempt(Runnable change) {
    try {
      change.run();
    } catch (IllegalArgumentException e) {
      // somebody wrote it into the file by hand
    }
  }

  /** Tells the settings. */
  static void remember(Snap snap, Settings settings) {
    settings.put(GRID, snap.grid());
    settings.put(ANGLE, snap.angle());
    for (Snap.To to : Snap.To.values()) {
      settings.put(name(to), snap.isOn(to));
    }
  }

  private static String name(Snap.To to) {
    return "snap." + to.name().toLowerCase(Locale.ROOT);
  }
}
