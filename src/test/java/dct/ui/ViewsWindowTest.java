package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.ui.canvas.CanvasPanel;
import dct.ui.result.ResultView;
import dct.ui.solve.ResultFrame;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Frame;
import java.awt.Point;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import org.assertj.swing.core.MouseButton;
import org.junit.jupiter.api.Test;

/** Results in frames and in the window, linked, compared and listed. */
class ViewsWindowTest extends WindowTest {
  private static final double[] DRAWN = {
    100, 100, 300, 60, 500, 120, 560, 300, 800, 200, 900, 400, 850, 600, 600, 650, 450, 500, 200,
    620, 80, 400
  };

  @Test
  void framesBesideEachOtherShowTheSamePart() {
    draw();
    ResultFrame old = pushForResult("Monotone Polygon Triangulation");
    ResultFrame flipped = pushForResult("Perform Flip");
    assertThat(old.getBounds().intersects(flipped.getBounds())).isFalse();
    perform("Link Views"); // off
    perform("Link Views"); // and on again
    zoomIn(old.canvas());
    await(
        "the other follows", () -> Math.abs(scale(old.canvas()) - scale(flipped.canvas())) < 1e-9);
    double middle = onEventThread(() -> middleX(old.canvas()));
    assertThat(onEventThread(() -> middleX(flipped.canvas()))).isCloseTo(middle, within(1e-6));
  }

  @Test
  void viewsThatAreNotLinkedStayWhereTheyAre() {
    draw();
    ResultFrame old = pushForResult("Monotone Polygon Triangulation");
    ResultFrame flipped = pushForResult("Perform Flip");
    perform("Link Views");
    double before = scale(flipped.canvas());
    zoomIn(old.canvas());
    assertThat(scale(flipped.canvas())).isEqualTo(before);
    assertThat(scale(old.canvas())).isGreaterThan(before);
  }

  @Test
  void resultsThatTheWindowCoversComeBackToTheFrontAndSoDoesTheDrawing() {
    draw();
    ResultFrame old = pushForResult("Monotone Polygon Triangulation");
    ResultFrame flipped = pushForResult("Perform Flip");
    iconify(old);
    perform("Results to Front");
    await("no icon is left", () -> onEventThread(() -> old.getExtendedState() == Frame.NORMAL));
    iconify(window);
    onEventThread(
        () -> {
          flipped.commands().get("Drawing to Front").perform();
          return null;
        });
    await(
        "the drawing is back",
        () -> onEventThread(() -> window.getExtendedState() == Frame.NORMAL));
    perform("Clear Canvas");
    perform("Results in This Window");
    assertThat(onEventThread(() -> window.commands().get("Results to Front").isEnabled()))
        .isFalse();
  }

  /** Makes a frame an icon and waits until it is one; the toolkit in memory does not tell. */
  private void iconify(Frame frame) {
    AtomicBoolean isIcon = new AtomicBoolean(!GuiToolkit.NATIVE);
    onEventThread(
        () -> {
          frame.addWindowListener(
              new WindowAdapter() {
                @Override
                public void windowIconified(WindowEvent e) {
                  isIcon.set(true);
                }
              });
          frame.setExtendedState(Frame.ICONIFIED);
          return null;
        });
    await("it is an icon", isIcon::get);
  }

  @Test
  void resultsMoveIntoTheWindowAndUndoTakesThemAway() {
    draw();
    pushForResult("Monotone Polygon Triangulation");
    perform("Results in This Window");
    assertThat(results()).isEmpty();
    await("the view", () -> views().size() == 1);
    perform("Perform Flip");
    await("both views", () -> views().size() == 2);
    perform("Undo");
    await("one is gone", () -> views().size() == 1);
    perform("Results in This Window");
    await("the frame", () -> results().size() == 1);
    assertThat(views()).isEmpty();
  }

  @Test
  void sitesThatWereAllInSightAreSoAgainThoughViewsHaveTakenRoomMeanwhile() {
    choose("Point Sites Based");
    check("Draw Vertex");
    clickAt(60, 60, 900, 80, 500, 640);
    draw();
    perform("Results in This Window");
    perform("Perform Flip");
    await("the view", () -> views().size() == 1);
    settle();
    choose("Point Sites Based");
    await("all in sight", () -> onEventThread(() -> canvas().isAllInSight()));
  }

  @Test
  void viewsAreArrangedAndMovedAndThatIsRemembered() {
    draw();
    perform("Results in This Window");
    perform("Monotone Polygon Triangulation");
    perform("Perform Flip");
    await("both views", () -> views().size() == 2);
    perform("Views Side by Side");
    await("beside each other", () -> place(0).y == place(1).y && place(0).x < place(1).x);
    perform("Views Stacked");
    await("below each other", () -> place(0).x == place(1).x && place(0).y < place(1).y);
    List<Component> before = views();
    perform("Move View Left");
    await("the other is first", () -> views().equals(List.of(before.get(1), before.get(0))));
    assertThat(onEventThread(() -> window.commands().get("Move View Left").isEnabled())).isFalse();
    assertThat(onEventThread(() -> window.commands().get("Move View Right").isEnabled())).isTrue();
    perform("Views as Tabs");
    await("one at a time", () -> views().size() == 1);
    onEventThread(
        () -> {
          window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_DEACTIVATED));
          return null;
        });
    assertThat(onEventThread(() -> session.settings().get("results.arrangement"))).hasValue("tabs");
  }

  @Test
  void theTitleOfAViewUsesTheRoomThatThereIsAndIsWholeUnderTheMouse() {
    draw();
    perform("Results in This Window");
    perform("Views as Tabs");
    perform("Perform Flip");
    await("the view", () -> views().size() == 1);
    JLabel title = robot.finder().findByName(window, "title", JLabel.class, true);
    assertThat(title.getText()).isEqualTo("Perform Flip after Monotone Polygon Triangulation");
    await("all of it is seen", () -> title.getWidth() >= title.getPreferredSize().width);
    JTabbedPane tabs = robot.finder().findByName(window, "results", JTabbedPane.class, true);
    String whole = title.getText() + " · New polygon";
    assertThat(tabs.getToolTipTextAt(0)).isEqualTo(whole);
    perform("Views Side by Side");
    JLabel above = robot.finder().findByName(window, "title", JLabel.class, true);
    assertThat(above.getToolTipText()).isEqualTo(whole);
  }

  @Test
  void menusAndToolsWorkOnTheViewThatIsUsed() {
    draw();
    perform("Results in This Window");
    perform("Perform Flip");
    await("the view", () -> views().size() == 1);
    ResultView view = (ResultView) onEventThread(() -> views().get(0));
    assertThat(isEnabled("Next Flip")).isFalse();
    click(() -> robot.click(view.canvas(), new Point(5, 5)));
    await("the view is in use", () -> isEnabled("Previous Flip"));
    perform("Flips");
    await("its panel", () -> isShown(view, "flips"));
    perform("Previous Flip");
    await("one flip less", () -> isEnabled("Next Flip"));
    double drawn = scale(canvas());
    perform("Link Views"); // off
    perform("Zoom In");
    assertThat(scale(canvas())).isEqualTo(drawn);
    click(() -> robot.click(canvas(), MouseButton.MIDDLE_BUTTON));
    await("the drawing is in use", () -> !isEnabled("Next Flip"));
    perform("Zoom In");
    assertThat(scale(canvas())).isGreaterThan(drawn);
    click(() -> robot.click(view.canvas(), new Point(5, 5)));
    await("the view is in use", () -> isEnabled("Next Flip"));
    onEventThread(
        () -> {
          view.close();
          return null;
        });
    assertThat(isEnabled("Next Flip")).isFalse();
  }

  private boolean isEnabled(String command) {
    return onEventThread(() -> window.commands().get(command).isEnabled());
  }

  private boolean isShown(ResultView view, String name) {
    return !robot
        .finder()
        .findAll(view, component -> name.equals(component.getName()) && component.isShowing())
        .isEmpty();
  }

  private Point place(int view) {
    return onEventThread(() -> SwingUtilities.convertPoint(views().get(view), new Point(), window));
  }

  @Test
  void whereResultsAreShownIsRemembered() {
    perform("Results in This Window");
    MainWindow next =
        onEventThread(
            () -> {
              window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_DEACTIVATED));
              return new Windows(session).openWindow();
            });
    assertThat(
            onEventThread(
                () ->
                    next.commands()
                        .get("Results in This Window")
                        .getValue(javax.swing.Action.SELECTED_KEY)))
        .isEqualTo(true);
    onEventThread(
        () -> {
          next.workbench().jobs().shutDown();
          next.dispose();
          return null;
        });
  }

  @Test
  void theTableListsAllResultsOfThePoints() {
    draw();
    pushForResult("Monotone Polygon Triangulation");
    perform("Perform Flip"); // the frames may cover the buttons
    perform("Convex Polygon Odd Triangulation");
    await("the frames", () -> results().size() == 3);
    perform("Table of Results");
    JTable table = onEventThread(() -> robot.finder().findByName("results", JTable.class, true));
    assertThat(onEventThread(table::getRowCount)).isEqualTo(3);
    List<String> words =
        onEventThread(
            () ->
                IntStream.range(0, 3)
                    .mapToObj(row -> String.valueOf(table.getValueAt(row, 0)))
                    .toList());
    assertThat(words).anyMatch(word -> word.startsWith("Perform Flip after Monotone"));
    perform("Undo");
    await("one less", () -> onEventThread(table::getRowCount) == 2);
  }

  /** The table of results, with two of them. */
  private JTable tableOfTwo() {
    draw();
    perform("Most Even Vertices");
    perform("Convex Polygon Odd Triangulation");
    await("the frames", () -> results().size() == 2);
    perform("Table of Results");
    return onEventThread(() -> robot.finder().findByName("results", JTable.class, true));
  }

  @Test
  void aLongVerdictIsSeenInFullOnASmallScreen() {
    JTable table = tableOfTwo();
    onEventThread(
        () -> {
          Window dialog = SwingUtilities.getWindowAncestor(table);
          dialog.setSize(800, 300);
          dialog.validate();
          return null;
        });
    await("the table is narrower", () -> onEventThread(table::getWidth) < 800);
    int last = table.getColumnCount() - 1;
    for (int row = 0; row < 2; row++) {
      int shown = row;
      Dimension needed =
          onEventThread(
              () -> {
                Component cell =
                    table.prepareRenderer(table.getCellRenderer(shown, last), shown, last);
                cell.setSize(table.getCellRect(shown, last, false).getSize());
                return cell.getPreferredSize();
              });
      assertThat(needed.width).isLessThanOrEqualTo(table.getCellRect(row, last, false).width);
      assertThat(needed.height).isLessThanOrEqualTo(table.getCellRect(row, last, false).height + 1);
      assertThat(table.getCellRect(row, last, true).getMaxX()).isLessThanOrEqualTo(800);
    }
    assertThat(onEventThread(() -> table.getValueAt(0, 0))).isEqualTo("Most Even Vertices");
  }

  @Test
  void enterComparesTheTwoChosenRowsOfTheTable() {
    JTable table = tableOfTwo();
    onEventThread(
        () -> {
          table.setRowSelectionInterval(0, 1);
          return table.requestFocusInWindow();
        });
    await("the table has the keyboard", () -> onEventThread(table::isFocusOwner));
    robot.pressAndReleaseKeys(KeyEvent.VK_ENTER);
    await("the comparison", () -> results().size() == 3);
  }

  @Test
  void compareShowsOnlyWhatDiffers() {
    draw();
    ResultFrame monotone = pushForResult("Monotone Polygon Triangulation");
    perform("Convex Polygon Odd Triangulation");
    await("the frames", () -> results().size() == 2);
    onEventThread(
        () -> {
          javax.swing.SwingUtilities.invokeLater(
              () -> window.commands().get("Compare Results…").perform());
          return null;
        });
    answer(dialog(), "Compare");
    await("the comparison", () -> results().size() == 3);
    ResultFrame comparison =
        results().stream()
            .map(ResultFrame.class::cast)
            .filter(frame -> frame.getTitle().startsWith("Comparison"))
            .findFirst()
            .orElseThrow();
    assertThat(String.join(" ", comparison.canvas().scene().counts())).contains("differ");
    assertThat(comparison.canvas().scene().edgeCount())
        .isNotEqualTo(monotone.canvas().scene().edgeCount());
    assertThat(
            onEventThread(
                () ->
                    robot
                        .finder()
                        .findByName(
                            comparison, "status", javax.swing.text.JTextComponent.class, true)
                        .getText()))
        .startsWith("A picture to look at");
  }

  private void draw() {
    choose("Polygon Based");
    check("Draw Vertex");
    clickAt(DRAWN);
  }

  private void zoomIn(CanvasPanel canvas) {
    onEventThread(
        () -> {
          canvas.zoom(2, 100, 80);
          return null;
        });
    settle();
  }

  private static double scale(CanvasPanel canvas) {
    return onEventThread(() -> canvas.viewport().scale());
  }

  private static double middleX(CanvasPanel canvas) {
    return canvas.viewport().modelX(canvas.getWidth() / 2.0);
  }

  /** The views within the main window. */
  private List<Component> views() {
    return onEventThread(
        () ->
            robot.finder().findAll(window, c -> c instanceof ResultView && c.isShowing()).stream()
                .map(Component.class::cast)
                .toList());
  }

  private void perform(String command) {
    onEventThread(
        () -> {
          window.commands().get(command).perform();
          return null;
        });
    settle();
  }
}
