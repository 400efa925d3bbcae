package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.PointFile;
import dct.ui.dialog.Chooser;
import dct.ui.dialog.Memory;
import dct.ui.dialog.Placement;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.menu.Look;
import dct.ui.session.Orphan;
import dct.ui.session.Session;
import dct.ui.session.Settings;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JMenuItem;
import org.assertj.swing.fixture.JFileChooserFixture;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;

/** What outlives a window and a run of the program: journals, settings, recent files. */
class SessionWindowTest extends WindowTest {
  private static final Points TRIANGLE = Points.ofPairs(100, 100, 500, 100, 300, 400);
  private static final double[] BOW_TIE = {100, 100, 500, 400, 500, 100, 100, 400};

  /** Not removed: a window that closes may still write its settings there. */
  @TempDir(cleanup = CleanupMode.NEVER)
  Path folder;

  private void drawTriangle() {
    choose("Polygon Based");
    clickAt(100, 100, 500, 100, 300, 400);
  }

  private void menu(String... items) {
    for (String item : items) {
      clickMenu(item);
    }
    settle();
  }

  private static List<MainWindow> windows() {
    return onEventThread(
        () ->
            Arrays.stream(java.awt.Frame.getFrames())
                .filter(f -> f instanceof MainWindow && f.isShowing())
                .map(MainWindow.class::cast)
                .toList());
  }

  private static void later(Runnable action) {
    javax.swing.SwingUtilities.invokeLater(action);
  }

  private List<Path> journals() throws Exception {
    session.journals().await();
    Path all = state.resolve("dct.journal");
    if (!Files.isDirectory(all)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(all)) {
      return files.filter(f -> f.toString().endsWith(".journal")).toList();
    }
  }

  @Test
  void aDrawingComesBackAfterTheProgramWasKilled() throws Exception {
    drawTriangle();
    assertThat(journals()).hasSize(1);
    // What a killed program leaves: the journal without its lease.
    Path left = Files.createDirectories(folder.resolve("dct.journal"));
    Files.copy(journals().get(0), left.resolve("a.journal"));
    Session next = Session.in(folder);
    List<Orphan> orphans = next.journals().orphans(unread -> {});
    Windows again = onEventThread(() -> new Windows(next));
    later(() -> again.offer(orphans, List.of()));
    JOptionPaneFixture question = dialog();
    assertThat(message(question))
        .startsWith("Recover the drawing of New polygon?")
        .contains("a polygon with 3 vertices");
    answer(question, "Recover");
    await("a window with the drawing", () -> windows().size() == 2);
    MainWindow recovered = windows().stream().filter(w -> w != window).findFirst().orElseThrow();
    assertThat(onEventThread(() -> recovered.workbench().document().points())).isEqualTo(TRIANGLE);
    assertThat(recovered.getTitle()).startsWith("*New polygon");
    assertThat(onEventThread(() -> recovered.commands().get("Undo").isEnabled()))
        .as("there is nothing before what was recovered")
        .isFalse();
    next.journals().await();
    assertThat(left.resolve("a.journal")).doesNotExist();
    try (Stream<Path> files = Files.list(left)) {
      assertThat(files.filter(f -> f.toString().endsWith(".journal"))).hasSize(1);
    }
  }

  @Test
  void noJournalStaysOfWhatIsSavedOrGivenUp() throws Exception {
    drawTriangle();
    assertThat(journals()).hasSize(1);
    menu("File", "Save");
    typeName(folder.resolve("mine").toString());
    settle();
    assertThat(journals()).isEmpty();
    clickAt(150, 300);
    assertThat(journals()).hasSize(1);
    menuForDialog("File", "Exit");
    answer(dialog(), "Don't Save");
    await("the window is closed", () -> !window.isShowing());
    assertThat(journals()).isEmpty();
  }

  private void menuForDialog(String... items) {
    for (String item : items) {
      clickMenu(item);
    }
  }

  @Test
  void exitSavesWhatIsNotSavedAndThenCloses() {
    drawTriangle();
    menuForDialog("File", "Exit");
    JOptionPaneFixture question = dialog();
    assertThat(message(question))
        .startsWith("Close the application?")
        .contains("New polygon has changes that are not saved.");
    answer(question, "Save");
    typeName(folder.resolve("mine").toString());
    await("the window is closed", () -> !window.isShowing());
    assertThat(folder.resolve("mine_polygonbased.txt")).hasContent("100 100\n500 100\n300 400\n");
  }

  @Test
  void anOptimumIsKeptInJsonAndVerifiedWhenItIsOpened() throws Exception {
    drawTriangle();
    clickAt(150, 350, 80, 200);
    menu("Triangulate", "Most Even Vertices");
    await("the result", () -> results().size() == 1);
    onEventThread(
        () -> {
          window.toFront();
          return null;
        });
    menuForDialog("File", "New");
    JOptionPaneFixture question = dialog();
    assertThat(message(question)).contains("changes and a triangulation that are not saved");
    answer(question, "Save");
    typeName(folder.resolve("best.json").toString());
    await("the new document", () -> points().size() == 0);
    Path file = folder.resolve("best.json");
    later(() -> window.open(file));
    await("the file", () -> points().size() == 5);
    settle();
    assertThat(onEventThread(() -> window.workbench().document().result().orElseThrow().title()))
        .isEqualTo("Most Even Vertices");
    assertThat(window.getTitle()).startsWith("best.json");
    Files.writeString(file, Files.readString(file).replaceFirst("\"even\": \\d+", "\"even\": 77"));
    later(() -> window.open(file));
    JOptionPaneFixture refusal = dialog();
    assertThat(message(refusal)).startsWith("best.json").contains("\"even\" says 77");
    answer(refusal, "OK");
  }

  @Test
  void aRecentFileIsOpenedAgainUnlessItIsGone() throws Exception {
    Path one = folder.resolve("one_polygonbased.txt");
    Path two = folder.resolve("two_polygonbased.txt");
    for (Path file : List.of(two, one)) {
      PointFile.write(file, Domain.POLYGON, TRIANGLE, Progress.NONE);
      later(() -> window.open(file));
      await("the file", () -> window.getTitle().startsWith(file.getFileName().toString()));
    }
    Files.delete(two);
    menu("File", "New");
    menuForDialog("File", "Open Recent");
    assertThat(item(two).isEnabled()).isFalse();
    clickMenu(one.toString());
    await("the file", () -> window.getTitle().startsWith("one_"));
    JMenuItem clear = frame.menuItem("Clear Recent").target();
    onEventThread(
        () -> {
          clear.doClick();
          return null;
        });
    assertThat(onEventThread(() -> session.recent().list())).isEmpty();
  }

  private JMenuItem item(Path file) {
    return frame.menuItem(file.toString()).target();
  }

  @Test
  void aNewWindowIsALittleLowerAndFurtherRight() {
    type(KeyEvent.VK_N, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    await("two windows", () -> windows().size() == 2);
    MainWindow other = windows().stream().filter(w -> w != window).findFirst().orElseThrow();
    Rectangle before = onEventThread(window::getBounds);
    Rectangle after = onEventThread(other::getBounds);
    assertThat(after.getSize()).isEqualTo(before.getSize());
    assertThat(after.getLocation()).isNotEqualTo(before.getLocation());
    later(other::exit);
    JOptionPaneFixture question = dialog();
    assertThat(message(question)).startsWith("Close this window?");
    answer(question, "Exit");
    await("one window", () -> windows().size() == 1);
  }

  @Test
  void exitAsksInEveryWindowAndOneCancelKeepsAllOpen() {
    drawTriangle();
    type(KeyEvent.VK_N, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    await("two windows", () -> windows().size() == 2);
    MainWindow other = windows().stream().filter(w -> w != window).findFirst().orElseThrow();
    later(() -> window.commands().get("Exit").perform());
    JOptionPaneFixture question = dialog();
    assertThat(message(question)).startsWith("Close the application with all its windows?");
    answer(question, "Cancel");
    assertThat(windows()).hasSize(2);
    onEventThread(
        () -> {
          other.workbench().choose(Domain.SITES);
          other.workbench().perform(Edit.draw(other.workbench().document(), 100, 100));
          return null;
        });
    later(() -> window.commands().get("Exit").perform());
    question = dialog();
    assertThat(message(question)).contains("New polygon has changes");
    answer(question, "Don't Save");
    question = dialog();
    assertThat(message(question)).contains("New sites has changes");
    answer(question, "Cancel");
    assertThat(windows()).hasSize(2);
    assertThat(points()).isEqualTo(TRIANGLE);
    later(() -> other.commands().get("Exit").perform());
    question = dialog();
    assertThat(message(question)).contains("New sites has changes");
    answer(question, "Don't Save");
    question = dialog();
    assertThat(message(question)).contains("New polygon has changes");
    answer(question, "Save");
    typeName(folder.resolve("mine").toString());
    await("no window", () -> windows().isEmpty());
    assertThat(folder.resolve("mine_polygonbased.txt")).hasContent("100 100\n500 100\n300 400\n");
  }

  @Test
  void exitOfWindowsThatHoldNothingAsksOnce() {
    choose("Polygon Based");
    type(KeyEvent.VK_N, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    await("two windows", () -> windows().size() == 2);
    later(() -> window.commands().get("Exit").perform());
    JOptionPaneFixture question = dialog();
    assertThat(message(question)).isEqualTo("Close the application with its 2 windows?");
    answer(question, "Exit");
    await("no window", () -> windows().isEmpty());
  }

  @Test
  void theFolderOfAFileIsWhereTheNextRunBegins() throws Exception {
    drawTriangle();
    menu("File", "Save");
    typeName(folder.resolve("mine").toString());
    settle();
    session.journals().await();
    Settings next = Session.in(state).settings();
    assertThat(next.get("folder.documents")).contains(folder.toAbsolutePath().toString());
    onEventThread(
        () -> {
          Memory.keepIn(next);
          return null;
        });
    later(() -> Chooser.DOCUMENTS.open(window, Optional.empty()));
    JFileChooserFixture chooser =
        org.assertj.swing.finder.JFileChooserFinder.findFileChooser()
            .withTimeout(PATIENCE_MILLIS)
            .using(robot);
    assertThat(onEventThread(() -> chooser.target().getCurrentDirectory().toPath()))
        .isEqualTo(folder.toAbsolutePath());
    chooser.cancel();
    await("the file panel is closed", () -> !chooser.target().isShowing());
  }

  @Test
  void theLookAndThePlaceAreRemembered() throws Exception {
    drawTriangle();
    onEventThread(
        () -> {
          Placement.setPlaced(window);
          window.setBounds(40, 30, 900, 650);
          return null;
        });
    type(KeyEvent.VK_N);
    type(KeyEvent.VK_U);
    type(KeyEvent.VK_F9);
    type(KeyEvent.VK_D, KeyEvent.VK_CONTROL);
    try {
      menuForDialog("File", "Exit");
      answer(dialog(), "Don't Save");
      await("the window is closed", () -> !window.isShowing());
      session.journals().await();
      Session next = Session.in(state);
      assertThat(next.settings().isOn("look.dark")).isTrue();
      MainWindow again = onEventThread(() -> new Windows(next).openWindow());
      assertThat(onEventThread(() -> again.canvas().labels().numbers())).isTrue();
      assertThat(onEventThread(() -> again.canvas().viewport().yUp())).isTrue();
      assertThat(onEventThread(() -> again.workbench().snap().words()))
          .isEqualTo("Snap: angles 15°");
      assertThat(onEventThread(() -> again.getSize())).isEqualTo(new java.awt.Dimension(900, 650));
    } finally {
      onEventThread(
          () -> {
            Look.setUp();
            return null;
          });
    }
  }

  @Test
  void theLiveTriangulationIsRememberedWithItsMethod() throws Exception {
    drawTriangle();
    clickAt(150, 350, 80, 200);
    frame.menuItem("View").click();
    menu("Live Method", "Live Ear Clipping Triangulation");
    session.journals().await();
    Editor live = onEventThread(() -> nextPolygon());
    assertThat(onEventThread(() -> live.live().orElseThrow().title()))
        .isEqualTo("Ear Clipping Triangulation");
    type(KeyEvent.VK_L);
    session.journals().await();
    Editor plain = onEventThread(() -> nextPolygon());
    assertThat(onEventThread(plain::live)).isEmpty();
    assertThat(Session.in(state).settings().get("live.method"))
        .contains("Ear Clipping Triangulation");
  }

  /** The polygon's editor in the first window of another run. */
  private Editor nextPolygon() {
    MainWindow next = new Windows(Session.in(state)).openWindow();
    next.dispose();
    return next.workbench().editor(Domain.POLYGON);
  }

  @Test
  void aMessageIsGoneWithTheNextChange() {
    drawTriangle();
    check("Edit Vertex");
    String hint = frame.label("status").text();
    menuForDialog("File", "Save");
    typeName(folder.resolve("mine").toString());
    settle();
    assertThat(frame.label("status").text()).startsWith("Saved ");
    moveTo(200, 200);
    assertThat(frame.label("status").text()).startsWith("Saved ");
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(frame.label("status").text()).isEqualTo(hint);
  }

  @Test
  void aPolygonThatIsNotSimpleIsUntangledInOneStep() {
    choose("Polygon Based");
    clickAt(BOW_TIE);
    check("Edit Vertex");
    assertThat(frame.label("status").text()).startsWith("Not simple: edges v0–v1 and v2–v3 cross");
    menu("Edit", "Go to Crossing");
    assertThat(at(canvas(), 300, 250)).isEqualTo(new java.awt.Point(500, 350));
    assertThat(frame.label("status").text()).startsWith("Here edges v0–v1 and v2–v3 cross");
    menu("Edit", "Untangle");
    assertThat(points()).isEqualTo(Points.ofPairs(100, 100, 500, 100, 500, 400, 100, 400));
    assertThat(frame.menuItem("Untangle").target().isEnabled()).isFalse();
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(points()).isEqualTo(Points.ofPairs(BOW_TIE));
    menu("Edit", "Use as Sites");
    frame.radioButton("Point Sites Based").requireSelected();
    assertThat(points()).isEqualTo(Points.ofPairs(BOW_TIE));
  }
}
