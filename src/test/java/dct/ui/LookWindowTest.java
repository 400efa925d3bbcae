package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dialog;
import java.awt.Font;
import java.awt.Window;
import java.awt.event.WindowEvent;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;

/** The light and the dark look of what is made once and shown later. */
class LookWindowTest extends WindowTest {
  /** The commands that open a dialog, in sites. */
  private static final List<String> DIALOGS =
      List.of(
          "Random Sites",
          "Search Options…",
          "Snap Settings…",
          "Table of Results",
          "Point Sites…",
          "Polygons…",
          "Regions with Holes…",
          "Commands and Keys",
          "Find Command…",
          "Export Picture",
          "Why?",
          "About");

  /** What a component looks like. */
  private record Appearance(Color background, Color foreground, Font font) {}

  @Test
  void everyDialogHasTheLookOfTheWindowWheneverItWasMade() {
    choose("Point Sites Based");
    check("Draw Vertex");
    clickAt(100, 100, 500, 120, 300, 400, 320, 250);
    perform("Dark Look");
    requireLook(DIALOGS);
    perform("Dark Look"); // light again
    requireLook(DIALOGS);
    choose("Polygon Based");
    perform("Dark Look");
    requireLook(List.of("Random Polygon…"));
  }

  private void requireLook(List<String> commands) {
    for (String command : commands) {
      perform(command);
      await("the dialog of " + command, () -> dialogs().size() == 1);
      onEventThread(
          () -> {
            requireUpToDate(command, dialogs().get(0));
            requireUpToDate("the window", window);
            return null;
          });
      close();
    }
  }

  /** Whether nothing changes when all is given the present look once more. */
  private static void requireUpToDate(String name, Window shown) {
    IdentityHashMap<Component, Appearance> before = new IdentityHashMap<>();
    note(shown, before);
    SwingUtilities.updateComponentTreeUI(shown);
    IdentityHashMap<Component, Appearance> after = new IdentityHashMap<>();
    note(shown, after);
    before.forEach(
        (part, look) ->
            assertThat(Optional.ofNullable(after.get(part)).orElse(look))
                .as(name + ": " + part)
                .isEqualTo(look));
  }

  private static void note(Component part, Map<Component, Appearance> all) {
    all.put(part, new Appearance(part.getBackground(), part.getForeground(), part.getFont()));
    if (part instanceof Container container) {
      Arrays.stream(container.getComponents()).forEach(inner -> note(inner, all));
    }
  }

  private static List<Window> dialogs() {
    return Arrays.stream(Window.getWindows())
        .filter(w -> w instanceof Dialog && w.isShowing())
        .toList();
  }

  private void close() {
    onEventThread(
        () -> {
          dialogs().forEach(w -> w.dispatchEvent(new WindowEvent(w, WindowEvent.WINDOW_CLOSING)));
          return null;
        });
    await("it is closed", () -> onEventThread(LookWindowTest::dialogs).isEmpty());
    robot.waitForIdle();
  }

  private void perform(String command) {
    SwingUtilities.invokeLater(() -> window.commands().get(command).perform());
    robot.waitForIdle();
  }
}
