package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.ui.canvas.CanvasPanel;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dialog;
import java.awt.Frame;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JProgressBar;
import javax.swing.JScrollBar;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTree;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;

/**
 * What a screen reader and a keyboard need of every window: names of all controls, a title, a
 * component that has the focus first, an Enter key that destroys nothing, an Esc key that closes.
 */
final class AccessLaws {
  private static final List<Class<?>> CONTROLS =
      List.of(
          AbstractButton.class,
          CanvasPanel.class,
          JComboBox.class,
          JList.class,
          JProgressBar.class,
          JSlider.class,
          JSpinner.class,
          JTabbedPane.class,
          JTable.class,
          JTextComponent.class,
          JTree.class);

  /** Text fields whose dialog is nothing but them, so that its title is their label. */
  private static final Set<String> WITHOUT_LABEL = Set.of("commandName");

  /** What is not to be done by a mere Enter. */
  private static final Set<String> DESTRUCTIVE =
      Set.of("Discard", "Don't Save", "Exit", "Overwrite", "Replace");

  private AccessLaws() {}

  /** The dialogs and frames that are shown. */
  static List<Window> windows() {
    return Arrays.stream(Window.getWindows())
        .filter(each -> (each instanceof Dialog || each instanceof Frame) && each.isShowing())
        .toList();
  }

  /** Does something on the event thread, and returns the window that it opens. */
  static Window open(String what, Runnable action) {
    List<Window> before = windows();
    SwingUtilities.invokeLater(action);
    List<Window> opened = new ArrayList<>();
    WindowTest.await(
        what + " opens a window",
        () -> {
          windows().stream().filter(each -> !before.contains(each)).forEach(opened::add);
          return !opened.isEmpty();
        });
    return opened.get(0);
  }

  /** Every showing control and every item of a menu has a name; there are so many at least. */
  static void requireNamed(Container of, int atLeast) {
    List<Component> controls = WindowTest.onEventThread(() -> controls(of));
    assertThat(controls).as("controls of " + of.getName()).hasSizeGreaterThanOrEqualTo(atLeast);
    for (Component control : controls) {
      String what = control.getName() + " " + control.getClass() + " of " + of.getName();
      assertThat(WindowTest.onEventThread(() -> name(control))).as(what).isNotBlank();
      if (control instanceof JTextComponent text && text.isEditable()) {
        requireLabel(text, what);
      }
      if (control instanceof JTable table) {
        requireWayOut(table, what);
      }
    }
  }

  /** Tab leaves a table, as it leaves every other control. */
  private static void requireWayOut(JTable table, String what) {
    assertThat(table.getFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS))
        .as(what)
        .contains(KeyStroke.getKeyStroke("pressed TAB"));
  }

  private static String name(Component control) {
    return control.getAccessibleContext().getAccessibleName();
  }

  private static void requireLabel(JTextComponent field, String what) {
    if (!WITHOUT_LABEL.contains(field.getName())) {
      Object label = field.getClientProperty("labeledBy"); // set by JLabel.setLabelFor
      assertThat(label).as("label of " + what).isInstanceOf(JLabel.class);
      assertThat(name(field)).as(what).isEqualTo(((JLabel) label).getText());
    }
  }

  /** A dialog has all names and a title, and can be begun and answered by the keyboard. */
  static void requireAnswerable(Dialog dialog) {
    assertThat(dialog.getTitle()).as("title of " + dialog).isNotBlank();
    requireNamed(dialog, 1);
    WindowTest.await(
        "the focus is first within " + dialog.getTitle(),
        () -> WindowTest.onEventThread(() -> isWithin(focused(dialog), dialog)));
    if (dialog instanceof JDialog shown && hasButtons(shown)) {
      WindowTest.await(dialog.getTitle() + " has a default button", () -> onEnter(shown) != null);
      assertThat(onEnter(shown).getText()).as(dialog.getTitle()).isNotIn(DESTRUCTIVE);
    }
  }

  /** What has the focus first; in memory a window itself takes it before what is in it. */
  private static Component focused(Dialog dialog) {
    Component focused = dialog.getMostRecentFocusOwner();
    return focused == dialog
        ? controls(dialog).stream().filter(Component::isFocusable).findFirst().orElseThrow()
        : focused;
  }

  private static boolean isWithin(Component focused, Dialog dialog) {
    return focused != null
        && focused.isEnabled()
        && SwingUtilities.isDescendingFrom(focused, dialog);
  }

  private static JButton onEnter(JDialog dialog) {
    return WindowTest.onEventThread(() -> dialog.getRootPane().getDefaultButton());
  }

  private static boolean hasButtons(JDialog dialog) {
    return WindowTest.onEventThread(() -> controls(dialog)).stream()
        .anyMatch(JButton.class::isInstance);
  }

  /** Presses Esc where the focus is in a dialog, and waits until the dialog is closed. */
  static void closeByEscape(Dialog dialog) {
    closeBy(KeyStroke.getKeyStroke("ESCAPE"), dialog);
  }

  /** Presses a key where the focus is in a dialog, and waits until the dialog is closed. */
  static void closeBy(KeyStroke key, Dialog dialog) {
    WindowTest.await(
        "a component of " + dialog.getTitle() + " has the focus",
        () -> WindowTest.onEventThread(() -> focused(dialog) != null));
    WindowTest.onEventThread(
        () -> {
          Component at = focused(dialog);
          for (int id : new int[] {KeyEvent.KEY_PRESSED, KeyEvent.KEY_RELEASED}) {
            long now = System.currentTimeMillis();
            int code = key.getKeyCode();
            at.dispatchEvent(
                new KeyEvent(at, id, now, key.getModifiers(), code, KeyEvent.CHAR_UNDEFINED));
          }
          return null;
        });
    WindowTest.await(dialog.getTitle() + " is closed by " + key, () -> !dialog.isShowing());
  }

  private static List<Component> controls(Container of) {
    List<Component> controls = new ArrayList<>();
    collect(of, controls);
    if (of instanceof Window && SwingUtilities.getRootPane(of).getJMenuBar() != null) {
      collectItems(SwingUtilities.getRootPane(of).getJMenuBar(), controls);
    }
    return controls;
  }

  private static void collectItems(Container menu, List<Component> controls) {
    for (Component child : menu.getComponents()) {
      if (child instanceof AbstractButton) {
        controls.add(child);
      }
      if (child instanceof JMenu inner) {
        collectItems(inner.getPopupMenu(), controls);
      }
    }
  }

  private static void collect(Container container, List<Component> controls) {
    for (Component child : container.getComponents()) {
      if (child.isShowing() && CONTROLS.stream().anyMatch(kind -> kind.isInstance(child))) {
        controls.add(child);
      }
      boolean isWhole =
          child instanceof JSpinner || child instanceof JComboBox || child instanceof JScrollBar;
      if (child instanceof JFileChooser chooser) {
        collectOurs(chooser, controls);
      } else if (child instanceof Container inner && !isWhole) {
        collect(inner, controls);
      }
    }
  }

  /** The toolkit names what is in a file panel; what is put beside it is to be named by us. */
  private static void collectOurs(JFileChooser chooser, List<Component> controls) {
    JComponent accessory = chooser.getAccessory();
    if (accessory != null) {
      collect(accessory, controls);
    }
    controls.add(SwingUtilities.getRootPane(chooser).getDefaultButton());
  }
}
