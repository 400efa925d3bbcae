package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.ui.command.Command;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.menu.CommandWindow;
import dct.ui.solve.ResultFrame;
import java.awt.Dialog;
import java.awt.Frame;
import java.awt.Window;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import javax.accessibility.AccessibleContext;
import javax.swing.JTabbedPane;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;

/** What a screen reader finds, and how the keyboard leaves it, in all that commands open. */
class AccessibleTreeTest extends WindowTest {
  private static final double[] DRAWN = {
    100, 100, 300, 60, 500, 120, 560, 300, 800, 200, 900, 400, 850, 600, 600, 650, 450, 500, 200,
    620, 80, 400
  };

  /** The commands by which a dialog opens, whatever the application. */
  private static final List<String> DIALOGS =
      List.of(
          "New",
          "Open",
          "Save",
          "Save As",
          "Export Picture",
          "Export Data",
          "Close Window",
          "Exit",
          "Wished Parities…",
          "Search Options…",
          "Point Sites…",
          "Polygons…",
          "Regions with Holes…",
          "Snap Settings…",
          "Compare Results…",
          "Table of Results",
          "Why?",
          "Verify Result",
          "Check Input",
          "Copy as Command Line", // cannot be, of a drawing that is in no file
          "Commands and Keys",
          "Find Command…",
          "About");

  private static final List<String> DIALOGS_OF_SITES =
      List.of(
          "Random Sites",
          "Save Flips…",
          "Load Flips…",
          "Apply Copied Flips", // cannot be, since the triangulation has them already
          "Paste"); // cannot be, since flips are no points

  private static final List<String> DIALOGS_OF_POLYGONS =
      List.of("Random Polygon…", "Random Region…");

  /** Of rings that meet themselves; AccessibleQuestionsTest walks it. */
  private static final List<String> OF_RINGS = List.of("Split Ring…");

  /** The commands by which a frame opens. */
  private static final List<String> FRAMES =
      List.of(
          "New Window",
          "Convex Polygon Even Triangulation",
          "Convex Polygon Odd Triangulation",
          "Monotone Polygon Triangulation",
          "Ear Clipping Triangulation",
          "Constrained Delaunay Triangulation",
          "Convex Partition",
          "Monotone Partition",
          "Perform Flip",
          "Most Even Vertices",
          "Most Odd Vertices");

  /** The commands of the frame of a result by which a dialog opens. */
  private static final List<String> OF_RESULTS =
      List.of(
          "Save",
          "Save As",
          "Export Picture",
          "Export Data",
          "Save Flips…",
          "Load Flips…",
          "Compare Results…",
          "Table of Results",
          "Why?",
          "Verify Result",
          "Commands and Keys",
          "Find Command…");

  @Test
  void theMainWindowAndItsResultsAreNamed() {
    AccessLaws.requireNamed(window, 10);
    draw("Polygon Based");
    ResultFrame result = pushForResult("Perform Flip");
    perform(result, "Flips");
    AccessLaws.requireNamed(result, 8);
    draw("Point Sites Based");
    perform(window, "Perform Flip");
    perform(window, "Flips");
    JTabbedPane tabs = frame.tabbedPane("tabs").target();
    for (int tab = 0; tab < tabs.getTabCount(); tab++) {
      int index = tab;
      onEventThread(
          () -> {
            tabs.setSelectedIndex(index);
            return null;
          });
      AccessLaws.requireNamed(window, 20);
    }
  }

  @Test
  void resultsInTheWindowAreNamed() {
    draw("Polygon Based");
    perform(window, "Results in This Window");
    perform(window, "Perform Flip");
    perform(window, "Most Even Vertices");
    for (String arrangement : List.of("Views Side by Side", "Views Stacked", "Views as Tabs")) {
      perform(window, arrangement);
      AccessLaws.requireNamed(window, 20);
    }
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
  void dialogsOfSitesAreNamedAndAnsweredByTheKeyboard() {
    prepareSites();
    requireDialogs(DIALOGS_OF_SITES);
  }

  @Test
  void dialogsOfPolygonsAreNamedAndAnsweredByTheKeyboard() {
    preparePolygon();
    requireDialogs(DIALOGS_OF_POLYGONS);
    ResultFrame result = (ResultFrame) results().get(0);
    OF_RESULTS.forEach(command -> requireDialog(result, command));
  }

  @Test
  void everyCommandForSitesThatOpensAWindowIsWalked() {
    prepareSites();
    requireNoOtherOpens();
  }

  @Test
  void everyCommandForPolygonsThatOpensAWindowIsWalked() {
    preparePolygon();
    ResultFrame result = (ResultFrame) results().get(0);
    for (Command command : result.commands().all()) {
      boolean asks = command.id().endsWith("…");
      assertThat(asks && !OF_RESULTS.contains(command.id())).as(command.id()).isFalse();
    }
    requireNoOtherOpens();
  }

  @Test
  void framesThatCommandsOpenAreNamed() {
    draw("Polygon Based");
    for (String command : FRAMES) {
      Window opened = open(window, command);
      assertThat(((Frame) opened).getTitle()).isNotBlank();
      AccessLaws.requireNamed(opened, 8);
    }
  }

  private void requireDialogs(List<String> more) {
    Stream.of(DIALOGS, more)
        .flatMap(List::stream)
        .forEach(command -> requireDialog(window, command));
  }

  private void requireDialog(CommandWindow of, String command) {
    Dialog opened = (Dialog) open(of, command);
    AccessLaws.requireAnswerable(opened);
    if (!opened.isModal()) {
      AccessLaws.closeBy(KeyStroke.getKeyStroke("ctrl W"), opened);
      robot.waitForIdle();
      opened = (Dialog) open(of, command);
    }
    AccessLaws.closeByEscape(opened);
    robot.waitForIdle();
  }

  /** Performs a command, and returns the window that it opens. */
  private Window open(CommandWindow of, String command) {
    assertThat(of.commands().get(command).isEnabled()).as(command + " is enabled").isTrue();
    Window opened = AccessLaws.open(command, () -> of.commands().get(command).perform());
    robot.waitForIdle();
    return opened;
  }

  /** Performs every command but those that open something, and finds that no window opens. */
  private void requireNoOtherOpens() {
    List<String> walked =
        Stream.of(DIALOGS, DIALOGS_OF_SITES, DIALOGS_OF_POLYGONS, OF_RINGS, FRAMES)
            .flatMap(List::stream)
            .toList();
    List<String> missing = new ArrayList<>();
    Points points = points();
    for (Command command : window.commands().all()) {
      if (!walked.contains(command.id()) && asks(command)) {
        missing.add(command.id());
      }
      restore(points);
    }
    assertThat(missing).as("commands that ask, and are in none of the lists above").isEmpty();
  }

  /** Whether a command says that it asks, or opens a window. */
  private boolean asks(Command command) {
    List<Window> before = AccessLaws.windows();
    SwingUtilities.invokeLater(command::perform);
    settle();
    List<Window> opened = AccessLaws.windows().stream().filter(w -> !before.contains(w)).toList();
    onEventThread(
        () -> {
          opened.forEach(Window::dispose);
          return null;
        });
    return command.id().endsWith("…") || !opened.isEmpty();
  }

  private void restore(Points points) {
    onEventThread(
        () -> {
          Editor editor = window.workbench().active().orElseThrow();
          if (!editor.document().points().equals(points)) {
            editor.perform(Edit.replace("Restore", editor.document(), points));
          }
          return null;
        });
    settle();
  }

  private void prepareSites() {
    draw("Point Sites Based");
    for (String command : List.of("Most Even Vertices", "Delaunay", "Perform Flip", "Copy Flips")) {
      perform(window, command);
    }
  }

  private void preparePolygon() {
    draw("Polygon Based");
    for (String command : List.of("Perform Flip", "Most Even Vertices")) {
      open(window, command);
      settle();
    }
  }

  private void draw(String application) {
    choose(application);
    onEventThread(
        () -> {
          Editor editor = window.workbench().active().orElseThrow();
          editor.perform(Edit.replace("Draw", editor.document(), Points.ofPairs(DRAWN)));
          return null;
        });
    settle();
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
