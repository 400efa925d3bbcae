package dct.ui.menu;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import dct.ui.session.Settings;
import java.awt.Window;
import java.util.Map;
import java.util.Optional;

/** The look and feel of all windows. */
public final class Look {

  private static final String DARK = "look.dark";

  private static Optional<Settings> remembered = Optional.empty();

  private Look() {}

  /**
   * Sets the look that these settings remember, and lets them remember it from now on; to be called
   * before the first window is made.
   */
  public static void setUp(Settings settings) {
    setUp();
    remembered = Optional.of(settings);
    if (settings.isOn(DARK)) {
      FlatDarkLaf.setup();
    }
  }

  /** Sets the light look; to be called before the first window is made. */
  public static void setUp() {
    remembered = Optional.empty();
    // Not by UIManager.put, which would set up the platform's own look first.
    FlatLaf.setGlobalExtraDefaults(
        Map.of(
            "Component.arc", "8",
            "Button.arc", "8",
            "Button.margin", "5,6,5,6",
            "ScrollBar.width", "12",
            "TitlePane.unifiedBackground", "false"));
    FlatLightLaf.setup();
  }

  /** Whether the look is dark. */
  public static boolean isDark() {
    return FlatLaf.isLafDark();
  }

  /** Changes all windows between light and dark. */
  public static void toggleDark() {
    if (isDark()) {
      FlatLightLaf.setup();
    } else {
      FlatDarkLaf.setup();
    }
    FlatLaf.updateUI();
    remembered.ifPresent(settings -> settings.put(DARK, isDark()));
    for (Window window : Window.getWindows()) {
      if (window instanceof CommandWindow other) {
        other.commands().refresh(); // its tick follows, too
      }
    }
  }
}
