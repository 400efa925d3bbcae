package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dct.core.geometry.Points;
import dct.ui.help.CommandFinder;
import dct.ui.help.CommandList;
import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.swing.JMenu;
import javax.swing.JTextField;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import org.junit.jupiter.api.Test;

/** The window in the hand of somebody who has no mouse. */
class KeyboardWindowTest extends WindowTest {

  /** Presses keys one after the other, wherever the focus is. */
  private void keys(int... codes) {
    robot.pressAndReleaseKeys(codes);
    robot.waitForIdle();
  }

  private void typeText(String text) {
    text.chars().map(KeyEvent::getExtendedKeyCodeForChar).forEach(this::keys);
  }

  private void withModifiers(int key, int... modifiers) {
    for (int modifier : modifiers) {
      robot.pressKey(modifier);
    }
    keys(key);
    for (int modifier : modifiers) {
      robot.releaseKey(modifier);
    }
    robot.waitForIdle();
  }

  private static boolean isOpen(Class<? extends Window> kind) {
    return onEventThread(
        () ->
            Arrays.stream(Window.getWindows()).anyMatch(w -> kind.isInstance(w) && w.isShowing()));
  }

  private static Component focused() {
    return onEventThread(
        () -> KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner());
  }

  private static void awaitFocus(String name) {
    await(
        "the focus is in " + name,
        () ->
            Optional.ofNullable(focused())
                .map(Component::getName)
                .filter(name::equals)
                .isPresent());
  }

  /** Finds a command by a part of its name and runs it; in memory, runs it as its menu would. */
  private void runByName(String part, String name) {
    takeKeyboard();
    if (!GuiToolkit.NATIVE) {
      SwingUtilities.invokeLater(() -> window.commands().get(name).perform());
      return;
    }
    withModifiers(KeyEvent.VK_A, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    awaitFocus("commandName");
    typeText(part);
    JTextField field = (JTextField) focused();
    await("the text", () -> part.equals(onEventThread(field::getText)));
    keys(KeyEvent.VK_ENTER);
    await("the finder has gone", () -> !isOpen(CommandFinder.class));
  }

  /** Moves the cross by so many tens and clicks there. */
  private void clickAfter(int right, int down) {
    for (int i = 0; i < Math.abs(right); i++) {
      type(right > 0 ? KeyEvent.VK_RIGHT : KeyEvent.VK_LEFT, KeyEvent.VK_SHIFT);
    }
    for (int i = 0; i < Math.abs(down); i++) {
      type(down > 0 ? KeyEvent.VK_DOWN : KeyEvent.VK_UP, KeyEvent.VK_SHIFT);
    }
    type(KeyEvent.VK_SPACE);
  }

  private void drawTriangle() {
    runByName("polygon based", "Polygon Based");
    await(
        "the polygon",
        () -> onEventThread(() -> frame.radioButton("Polygon Based").target().isSelected()));
    type(KeyEvent.VK_D);
    clickAfter(4, 4);
    clickAfter(9, 0);
    clickAfter(-3, 8);
    assertThat(points().size()).isEqualTo(3);
    type(KeyEvent.VK_ESCAPE);
    frame.checkBox("Edit Vertex").requireSelected();
  }

  private static Points shifted(Points points, int v, double dx, double dy) {
    return points.moved(v, points.x(v) + dx, points.y(v) + dy);
  }

  @Test
  void aCommandIsFoundByNameAndRun() {
    assumeTrue(GuiToolkit.NATIVE, "in memory these keys open nothing");
    runByName("dark", "Dark Look");
    await("it is dark", () -> onEventThread(dct.ui.menu.Look::isDark));
    runByName("dark", "Dark Look");
    await("it is light", () -> !onEventThread(dct.ui.menu.Look::isDark));
  }

  @Test
  void theFinderAndTheListOfKeysCloseByEscape() {
    assumeTrue(GuiToolkit.NATIVE, "in memory these keys open nothing");
    takeKeyboard();
    withModifiers(KeyEvent.VK_A, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    awaitFocus("commandName");
    keys(KeyEvent.VK_ESCAPE);
    await("the finder has gone", () -> !isOpen(CommandFinder.class));
    takeKeyboard();
    keys(KeyEvent.VK_F1);
    awaitFocus("searchCommands");
    keys(KeyEvent.VK_ESCAPE);
    await("the list has gone", () -> !isOpen(CommandList.class));
  }

  @Test
  void theCanvasHasALineRoundItWhenTheKeyboardReachesIt() {
    int accent = onEventThread(() -> UIManager.getColor("Component.accentColor").getRGB());
    robot.focusAndWaitForFocusGain(frame.radioButton("Polygon Based").target());
    onEventThread(() -> canvas().requestFocusInWindow(FocusEvent.Cause.TRAVERSAL_BACKWARD));
    await("the line", () -> capture(canvas()).getRGB(1, 300) == accent);
    clickAt(500, 300);
    await("no line", () -> capture(canvas()).getRGB(1, 300) != accent);
    assertThat(onEventThread(canvas()::isFocusOwner)).isTrue();
  }

  @Test
  void theCanvasHasTheFocusAfterAnInvitationThatIsTaken() {
    robot.focusAndWaitForFocusGain(
        robot.finder().findByName(canvas(), "Open, Degree Constrained Triangulation"));
    onEventThread(
        () -> {
          window.commands().get("Polygon Based").perform();
          return null;
        });
    await("the canvas has the keyboard", () -> onEventThread(canvas()::isFocusOwner));
    type(KeyEvent.VK_DOWN, KeyEvent.VK_SHIFT);
    type(KeyEvent.VK_SPACE);
    assertThat(points().size()).isEqualTo(1);
  }

  @Test
  void randomSitesAreAskedForByKeysAlone() {
    runByName("point sites based", "Point Sites Based");
    runByName("random sites", "Random Sites");
    awaitFocus("vertices");
    typeText("25");
    keys(KeyEvent.VK_TAB);
    awaitFocus("shape");
    keys(KeyEvent.VK_TAB);
    awaitFocus("seed");
    typeText("7");
    keys(KeyEvent.VK_ENTER);
    await("the sites", () -> points().size() == 25);
    settle();
    requireNoDialog();
  }

  @Test
  void enterAddsAVertexAndWhereThatIsEndsTheDrawing() {
    choose("Polygon Based");
    for (int side = 0; side < 3; side++) {
      type(side == 1 ? KeyEvent.VK_DOWN : KeyEvent.VK_RIGHT, KeyEvent.VK_SHIFT);
      type(KeyEvent.VK_ENTER);
    }
    assertThat(points().size()).isEqualTo(3);
    frame.checkBox("Draw Vertex").requireSelected();
    type(KeyEvent.VK_ENTER);
    frame.checkBox("Edit Vertex").requireSelected();
    assertThat(points().size()).isEqualTo(3);
  }

  @Test
  void aPolygonIsDrawnSelectedMovedAndCopiedByKeys() {
    drawTriangle();
    Points drawn = points();
    type(KeyEvent.VK_SPACE); // the cross still is on v2
    assertThat(selected()).containsExactly(2);
    type(KeyEvent.VK_RIGHT);
    assertThat(points()).isEqualTo(shifted(drawn, 2, 1, 0));
    type(KeyEvent.VK_UP, KeyEvent.VK_SHIFT);
    assertThat(points()).isEqualTo(shifted(drawn, 2, 1, -10));
    type(KeyEvent.VK_D, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    int n = points().size();
    assertThat(n).as("duplicated").isEqualTo(4);
    type(KeyEvent.VK_X, KeyEvent.VK_CONTROL);
    await("cut", () -> points().size() == n - 1);
    type(KeyEvent.VK_V, KeyEvent.VK_CONTROL);
    await("pasted", () -> points().size() == n);
    type(KeyEvent.VK_C, KeyEvent.VK_CONTROL);
    type(KeyEvent.VK_DELETE);
    await("deleted", () -> points().size() == n - 1);
    type(KeyEvent.VK_V, KeyEvent.VK_CONTROL);
    await("pasted again", () -> points().size() == n);
  }

  private List<Integer> selected() {
    return onEventThread(
        () -> {
          List<Integer> all = new ArrayList<>();
          var selection = window.workbench().selection();
          for (int v = selection.next(0); v >= 0; v = selection.next(v + 1)) {
            all.add(v);
          }
          return all;
        });
  }

  @Test
  void altAndALetterOpensEachMenu() {
    assumeTrue(GuiToolkit.NATIVE, "in memory these keys open nothing");
    takeKeyboard();
    Set<Integer> letters = new HashSet<>();
    for (JMenu menu : menus()) {
      int letter = onEventThread(menu::getMnemonic);
      assertThat(letters.add(letter)).as("%s has a letter of its own", menu.getText()).isTrue();
      withModifiers(letter, KeyEvent.VK_ALT);
      await(menu.getText() + " is open", () -> onEventThread(menu::isPopupMenuVisible));
      assertThat(onEventThread(menu::getMenuComponentCount)).isPositive();
      onEventThread(
          () -> {
            MenuSelectionManager.defaultManager().clearSelectedPath();
            return null;
          });
      await(menu.getText() + " is closed", () -> !onEventThread(menu::isPopupMenuVisible));
    }
    assertThat(letters).hasSizeGreaterThan(7).doesNotContain(0);
  }

  private List<JMenu> menus() {
    return onEventThread(
        () ->
            Arrays.stream(window.getJMenuBar().getComponents())
                .filter(JMenu.class::isInstance)
                .map(JMenu.class::cast)
                .toList());
  }
}
