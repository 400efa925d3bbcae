package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.core.triangulate.Triangulation;
import dct.render.Ink;
import dct.render.Theme;
import dct.ui.canvas.CanvasPanel;
import dct.ui.menu.Look;
import dct.ui.result.HintText;
import dct.ui.session.Session;
import dct.ui.solve.ResultFrame;
import java.awt.Component;
import java.awt.Dialog;
import java.awt.Frame;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JFrame;
import javax.swing.JOptionPane;
import javax.swing.JTextField;
import org.assertj.swing.core.BasicRobot;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.edt.GuiActionRunner;
import org.assertj.swing.finder.JFileChooserFinder;
import org.assertj.swing.finder.JOptionPaneFinder;
import org.assertj.swing.finder.WindowFinder;
import org.assertj.swing.fixture.FrameFixture;
import org.assertj.swing.fixture.JFileChooserFixture;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.assertj.swing.fixture.JTextComponentFixture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;

/** A real main window, used with a real mouse and keyboard. */
@Tag("gui")
abstract class WindowTest {
  static final long PATIENCE_MILLIS = 30_000;

  static {
    GuiToolkit.load();
  }

  /**
   * What the program would keep in the user's own folder; a second session may still write there.
   */
  @TempDir(cleanup = CleanupMode.NEVER)
  Path state;

  Session session;
  org.assertj.swing.core.Robot robot;
  private final InputLog input = new InputLog();
  MainWindow window;
  FrameFixture frame;
  private Robot screen;

  @BeforeEach
  void openWindow() throws Exception {
    screen = new Robot();
    robot = BasicRobot.robotWithNewAwtHierarchy();
    input.start();
    // Waiting is done for conditions, not for time to pass.
    robot.settings().delayBetweenEvents(4);
    robot.settings().eventPostingDelay(10);
    window =
        GuiActionRunner.execute(
            () -> {
              session = Session.in(state);
              Look.setUp(session.settings());
              return new Windows(session).openWindow();
            });
    frame = new FrameFixture(robot, window);
    frame.show();
    await("the window has its size", () -> canvas().getWidth() == 1000);
    robot.waitForIdle();
  }

  @AfterEach
  void closeWindow() throws InterruptedException {
    input.stop();
    robot.cleanUp();
    onEventThread(
        () -> {
          window.workbench().jobs().shutDown();
          Arrays.stream(Window.getWindows()).forEach(Window::dispose);
          return null;
        });
    session.journals().await(); // lest the folder be removed before
  }

  CanvasPanel canvas() {
    return window.canvas();
  }

  /** Chooses Polygon Based or Point Sites Based. */
  void choose(String application) {
    click(() -> frame.radioButton(application).click());
    frame.radioButton(application).requireSelected();
  }

  /** Chooses a mouse mode. */
  void check(String tool) {
    click(() -> frame.checkBox(tool).click());
    frame.checkBox(tool).requireSelected();
  }

  /** Does something that clicks, and waits until the click has arrived and its work is done. */
  void click(Runnable clicks) {
    long before = input.mouseReleases();
    clicks.run();
    await("the click", () -> input.mouseReleases() > before);
    settle();
  }

  /** Clicks at these model coordinates, one place after the other: x0, y0, x1, y1, …. */
  void clickAt(double... coordinates) {
    for (int i = 0; i < coordinates.length; i += 2) {
      Point place = at(canvas(), coordinates[i], coordinates[i + 1]);
      click(() -> robot.click(canvas(), place));
    }
  }

  void press(double x, double y) {
    moveTo(x, y);
    long before = input.mousePresses();
    robot.pressMouse(MouseButton.LEFT_BUTTON);
    await("the press", () -> input.mousePresses() > before);
  }

  void moveTo(double x, double y) {
    Point place = at(canvas(), x, y);
    robot.moveMouse(canvas(), place);
    await("the move", () -> input.isMouseAt(canvas(), place));
    settle();
  }

  void release() {
    click(() -> robot.releaseMouse(MouseButton.LEFT_BUTTON));
  }

  /** Presses a key while others are down, in the main window. */
  void type(int key, int... modifiers) {
    takeKeyboard();
    long before = input.keyReleases();
    for (int modifier : modifiers) {
      robot.pressKey(modifier);
    }
    robot.pressAndReleaseKeys(key);
    for (int modifier : modifiers) {
      robot.releaseKey(modifier);
    }
    await("the keys", () -> input.keyReleases() > before + modifiers.length);
    settle();
  }

  /** Gives the canvas the keyboard, which after a dialog comes back some time later. */
  void takeKeyboard() {
    if (!askForKeyboard()) {
      click(() -> robot.click(canvas(), MouseButton.MIDDLE_BUTTON)); // pans by nothing
      await("the canvas has the keyboard", () -> askForKeyboard() || forgetClosedDialog());
    }
  }

  private boolean askForKeyboard() {
    onEventThread(canvas()::requestFocusInWindow);
    robot.waitForIdle();
    return onEventThread(() -> window.isFocused() && canvas().isFocusOwner());
  }

  /**
   * In memory the focus sometimes stays in a dialog that is closed, and no click brings it back; it
   * comes back from a window that opens and closes.
   */
  private boolean forgetClosedDialog() {
    Window focused = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusedWindow();
    if (focused != null && !focused.isShowing()) {
      JFrame other =
          onEventThread(
              () -> {
                JFrame opened = new JFrame();
                opened.setVisible(true);
                return opened;
              });
      robot.waitForIdle();
      onEventThread(
          () -> {
            other.dispose();
            return null;
          });
      robot.waitForIdle();
    }
    return askForKeyboard();
  }

  /** Types a text in place of what a field holds. */
  void fill(JTextComponentFixture field, String text) {
    field.deleteText().enterText(text);
    await("the text", () -> text.equals(field.text()));
  }

  /** Types a file's name into the file panel and presses Enter. */
  void typeName(String name) {
    JFileChooserFixture chooser =
        JFileChooserFinder.findFileChooser().withTimeout(PATIENCE_MILLIS).using(robot);
    fill(new JTextComponentFixture(robot, nameField(chooser)), name);
    robot.pressAndReleaseKeys(KeyEvent.VK_ENTER);
    await("the file panel is closed", () -> !chooser.target().isShowing());
    robot.waitForIdle();
  }

  /** The one field that is not for another answer beside the file. */
  private JTextField nameField(JFileChooserFixture chooser) {
    return (JTextField)
        robot
            .finder()
            .find(
                chooser.target(),
                each -> each instanceof JTextField && !(each.getParent() instanceof JComboBox));
  }

  /** The points of the document that is shown. */
  Points points() {
    return onEventThread(() -> window.workbench().document().points());
  }

  /** Clicks a button of the east panel. */
  void push(String button) {
    click(() -> frame.button(button).click());
  }

  /** Clicks a menu of the menu bar, or an item of the menu that is open. */
  void clickMenu(String name) {
    clickForDialog(() -> frame.menuItem(name).click());
  }

  /** Does something that clicks and may open a dialog. */
  void clickForDialog(Runnable clicks) {
    // A click that opens a dialog returns from the event queue only after its answer.
    long before = input.mouseReleases();
    clicks.run();
    await("the click", () -> input.mouseReleases() > before);
    robot.waitForIdle();
  }

  /** Pushes a button that opens a frame of results, and returns it. */
  ResultFrame pushForResult(String button) {
    List<Frame> before = results();
    click(() -> frame.button(button).click());
    await("a new frame", () -> results().size() > before.size());
    settle();
    ResultFrame result =
        (ResultFrame) results().stream().filter(f -> !before.contains(f)).findFirst().orElseThrow();
    await("the frame is shown", result::isShowing);
    return result;
  }

  static List<Frame> results() {
    return onEventThread(
        () ->
            Arrays.stream(Frame.getFrames())
                .filter(f -> f instanceof ResultFrame && f.isShowing())
                .toList());
  }

  /** What the status line of a frame of results says. */
  String status(ResultFrame frame) {
    return onEventThread(
        () -> robot.finder().findByName(frame, "status", HintText.class, true).getText());
  }

  /** Waits for the one dialog that there is. */
  JOptionPaneFixture dialog() {
    return JOptionPaneFinder.findOptionPane().withTimeout(PATIENCE_MILLIS).using(robot);
  }

  static String message(JOptionPaneFixture dialog) {
    JOptionPane pane = dialog.target();
    return onEventThread(() -> String.valueOf(pane.getMessage()));
  }

  static String title(JOptionPaneFixture dialog) {
    return onEventThread(
        () -> ((Dialog) javax.swing.SwingUtilities.getWindowAncestor(dialog.target())).getTitle());
  }

  /** Clicks a button of a dialog and waits until the dialog is gone. */
  void answer(JOptionPaneFixture dialog, String button) {
    JOptionPane pane = dialog.target();
    robot.click(
        robot
            .finder()
            .find(
                pane,
                new org.assertj.swing.core.GenericTypeMatcher<JButton>(JButton.class, true) {
                  @Override
                  protected boolean isMatching(JButton candidate) {
                    return button.equals(candidate.getText());
                  }
                }));
    await("the dialog is closed", () -> !pane.isShowing());
    settle();
  }

  static void requireNoDialog() {
    assertThat(
            Arrays.stream(Window.getWindows())
                .filter(w -> w instanceof Dialog && w.isShowing())
                .toList())
        .isEmpty();
  }

  /** Waits until all events are handled and all background work is done. */
  void settle() {
    robot.waitForIdle();
    await("the work is done", () -> onEventThread(() -> window.workbench().jobs().isIdle()));
    robot.waitForIdle();
  }

  static void await(String what, BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE_MILLIS * 1_000_000;
    while (!condition.getAsBoolean()) {
      assertThat(System.nanoTime() < end).as("in time: " + what).isTrue();
      java.util.concurrent.locks.LockSupport.parkNanos(10_000_000);
    }
  }

  static <T> T onEventThread(Callable<T> action) {
    return GuiActionRunner.execute(action);
  }

  /** Where a model point is on a canvas, in pixels. */
  static Point at(CanvasPanel canvas, double x, double y) {
    return onEventThread(
        () ->
            new Point(
                (int) Math.round(canvas.viewport().screenX(x)),
                (int) Math.round(canvas.viewport().screenY(y))));
  }

  /** Waits until the screen shows this colour within two pixels of a model point. */
  void requireInk(CanvasPanel canvas, Ink ink, double x, double y) {
    Point place = at(canvas, x, y);
    await(
        ink + " at (" + x + ", " + y + ")",
        () -> shows(capture(canvas), place, new java.awt.Color(ink.rgb(Theme.LIGHT))));
  }

  private static boolean shows(BufferedImage image, Point place, java.awt.Color wanted) {
    for (int dy = -2; dy <= 2; dy++) {
      for (int dx = -2; dx <= 2; dx++) {
        int x = Math.max(0, Math.min(image.getWidth() - 1, place.x + dx));
        int y = Math.max(0, Math.min(image.getHeight() - 1, place.y + dy));
        if (near(new java.awt.Color(image.getRGB(x, y)), wanted)) {
          return true;
        }
      }
    }
    return false;
  }

  /** A thin line is blended with the white ground: half of its colour, or more, is to be seen. */
  private static boolean near(java.awt.Color seen, java.awt.Color wanted) {
    for (double part = 1; part >= 0.5; part -= 0.05) {
      if (difference(seen.getRed(), wanted.getRed(), part) < 16
          && difference(seen.getGreen(), wanted.getGreen(), part) < 16
          && difference(seen.getBlue(), wanted.getBlue(), part) < 16) {
        return true;
      }
    }
    return false;
  }

  private static double difference(int seen, int wanted, double part) {
    return Math.abs(seen - (part * wanted + (1 - part) * 255));
  }

  /** What the screen shows of a component. */
  BufferedImage capture(Component component) {
    Rectangle bounds =
        onEventThread(() -> new Rectangle(component.getLocationOnScreen(), component.getSize()));
    return screen.createScreenCapture(bounds);
  }

  /** Every vertex and the middle of every edge of a triangulation have their colours. */
  void requireShown(CanvasPanel canvas, Triangulation triangulation) {
    Points points = triangulation.points();
    for (int v = 0; v < triangulation.vertexCount(); v++) {
      requireInk(canvas, triangulation.isEven(v) ? Ink.EVEN : Ink.ODD, points.x(v), points.y(v));
    }
    for (int edge = 0; edge < triangulation.edgeCount(); edge++) {
      int a = triangulation.from(edge);
      int b = triangulation.to(edge);
      Ink ink =
          switch (triangulation.kind(edge)) {
            case BOUNDARY -> Ink.BOUNDARY;
            case DIAGONAL -> Ink.DIAGONAL;
            case PARTITION -> Ink.PARTITION;
            case FLIPPED -> Ink.FLIPPED;
            case FIXED -> Ink.FIXED;
          };
      requireInk(canvas, ink, (points.x(a) + points.x(b)) / 2, (points.y(a) + points.y(b)) / 2);
    }
  }

  /** A frame found by its type, as a fixture. */
  FrameFixture fixture(ResultFrame result) {
    return WindowFinder.findFrame(
            new org.assertj.swing.core.GenericTypeMatcher<ResultFrame>(ResultFrame.class) {
              @Override
              protected boolean isMatching(ResultFrame candidate) {
                return candidate == result;
              }
            })
        .using(robot);
  }
}
