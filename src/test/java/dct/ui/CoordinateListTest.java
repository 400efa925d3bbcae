package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.ui.menu.Look;
import java.awt.Color;
import java.awt.Component;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import org.junit.jupiter.api.Test;

class CoordinateListTest {

  @Test
  void inEveryLookTheGroundIsThatOfATextThatIsNotDisabled() throws Exception {
    SwingUtilities.invokeAndWait(
        () -> {
          Look.setUp();
          CoordinateList list = new CoordinateList();
          requireBright(list);
          for (int i = 0; i < 2; i++) {
            Look.toggleDark();
            SwingUtilities.updateComponentTreeUI(list);
            requireBright(list);
          }
        });
  }

  private static void requireBright(CoordinateList list) {
    Component text = list.getViewport().getView();
    Color bright = UIManager.getColor("TextField.background");
    assertThat(text.getBackground().getRGB()).isEqualTo(bright.getRGB());
  }
}
