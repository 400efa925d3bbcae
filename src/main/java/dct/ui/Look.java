package dct.ui;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Insets;
import javax.swing.UIManager;

/** The look and feel of all windows. */
public final class Look {

  private Look() {}

  /** Sets the light look; to be called before the first window is made. */
  public static void setUp() {
    UIManager.put("Component.arc", 8);
    UIManager.put("Button.arc", 8);
    UIManager.put("Button.margin", new Insets(5, 6, 5, 6));
    UIManager.put("ScrollBar.width", 12);
    UIManager.put("TitlePane.unifiedBackground", false);
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
  }
}
