package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.ui.canvas.CanvasPanel;
import dct.ui.menu.CommandWindow;
import dct.ui.solve.ResultFrame;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dialog;
import java.awt.Window;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.accessibility.AccessibleContext;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JProgressBar;
import javax.swing.JScrollBar;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;

/** What a screen reader finds: every control and every canvas has a name. */
class AccessibleTreeTest extends WindowTest {
  private static final double[] DRAWN = {
    100, 100, 300, 60, 500, 120, 560, 300, 800, 200, 900, 400, 850, 600, 600, 650, 450, 500, 200,
    620, 80, 400
  };

  private static final List<Class<?>> CONTROLS =
      List.of(
          AbstractButton.class,
          CanvasPanel.class,
          JComboBox.class,
          JProgressBar.class,
          JSlider.class,
          JSpinner.class,
          JTabbedPane.class,
          JTable.class,
          JTextComponent.class);

  @Test
  void theMainWindowAndItsResultsAreNamed() {
    requireNamed(window, 10);
    draw("Polygon Based");
    ResultFrame frame = pushForResult("Perform Flip");
    perform(frame, "Flips");
    requireNamed(frame, 8);
    draw("Point Sites Based");
    perform(window, "Perform Flip");
    perform(window, "Flips");
    requireNamed(window, 20);
  }

  @Test
  void canvasAndStatusLineSayWhatIsThere() {
    draw("Point Sites Based");
    String canvas = onEventThread(() -> canvas().getAccessibleContext().getAccessibleDescription());
    assertThat(canvas)
        .contains("11 sites")
        .containsIgnoringCase("even")
        .containsIgnoringCase("odd");
    AccessibleContext status = frame.label("status").target().getAccessibleContext();
    List<Object> heard = new CopyOnWriteArrayList<>();
    status.addPropertyChangeListener(
        change -> {
          if (AccessibleContext.ACCESSIBLE_DESCRIPTION_PROPERTY.equals(change.getPropertyName())) {
            heard.add(change.getNewValue());
          }
        });
    check("Split Vertex");
    String text = onEventThread(() -> frame.label("status").target().getText());
    assertThat(heard).last().isEqualTo(text);
    assertThat(onEventThread(status::getAccessibleDescription)).isEqualTo(text).isNotBlank();
    assertThat(onEventThread(status::getAccessibleName)).isEqualTo("Status");
  }

  @Test
  void dialogsBesideTheWindowAreNamed() {
    draw("Point Sites Based");
    for (String command :
        List.of(
            "Commands and Keys", "Find Command…", "Why?", "Verify Result", "Table of Results")) {
      List<Dialog> before = dialogs();
      perform(window, command);
      await(command, () -> dialogs().size() > before.size());
      Dialog opened =
          dialogs().stream().filter(dialog -> !before.contains(dialog)).findFirst().orElseThrow();
      requireNamed(opened, 1);
      onEventThread(
          () -> {
            opened.dispose();
            return null;
          });
    }
  }

  @Test
  void questionsAreNamed() {
    draw("Point Sites Based");
    for (String command :
        List.of("Random Sites", "Search Options…", "Snap Settings…", "Wished Parities…")) {
      onEventThread(
          () -> {
            javax.swing.SwingUtilities.invokeLater(() -> window.commands().get(command).perform());
            return null;
          });
      await(command, () -> dialogs().size() == 1);
      requireNamed(dialogs().get(0), 2);
      onEventThread(
          () -> {
            dialogs().get(0).dispose();
            return null;
          });
      await("closed", () -> dialogs().isEmpty());
    }
  }

  private static List<Dialog> dialogs() {
    return Arrays.stream(Window.getWindows())
        .filter(each -> each instanceof Dialog && each.isShowing())
        .map(Dialog.class::cast)
        .toList();
  }

  /** Every showing control of a window has a name; there are so many of them at least. */
  private static void requireNamed(Window of, int atLeast) {
    List<Component> controls = new ArrayList<>();
    onEventThread(
        () -> {
          collect(of, controls);
          return null;
        });
    assertThat(controls).as("controls of " + of.getName()).hasSizeGreaterThanOrEqualTo(atLeast);
    for (Component control : controls) {
      AccessibleContext context = control.getAccessibleContext();
      String name = onEventThread(context::getAccessibleName);
      assertThat(name).as("%s %s", control.getName(), control.getClass()).isNotBlank();
    }
  }

  private static void collect(Container container, List<Component> controls) {
    for (Component child : container.getComponents()) {
      boolean isControl = CONTROLS.stream().anyMatch(kind -> kind.isInstance(child));
      if (isControl && child.isShowing()) {
        controls.add(child);
      }
      boolean isWhole = child instanceof JSpinner || child instanceof JComboBox;
      if (child instanceof Container inner && !isWhole && !(child instanceof JScrollBar)) {
        collect(inner, controls);
      }
    }
  }

  private void draw(String application) {
    choose(application);
    check("Draw Vertex");
    clickAt(DRAWN);
  }

  private void perform(CommandWindow of, String command) {
    onEventThread(
        () -> {
          of.commands().get(command).perform();
          return null;
        });
    settle();
  }
}
