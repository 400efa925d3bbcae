package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.PointFile;
import dct.ui.file.Samples;
import dct.ui.solve.ResultFrame;
import java.awt.event.KeyEvent;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.assertj.swing.finder.JFileChooserFinder;
import org.assertj.swing.fixture.JFileChooserFixture;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The File menu, by mouse and keyboard. */
class FilesWindowTest extends WindowTest {
  private static final Points TRIANGLE = Points.ofPairs(100, 100, 500, 100, 300, 400);

  @TempDir Path folder;

  @Test
  void theStartLetsTheUserChooseTheApplication() {
    frame.radioButton("Polygon Based").requireNotSelected();
    frame.radioButton("Point Sites Based").requireNotSelected();
    assertThat(frame.label("status").text()).contains("Choose Polygon Based or Point Sites Based");
    choose("Polygon Based");
    frame.button("Convex Polygon Odd Triangulation").requireVisible();
    choose("Point Sites Based");
    frame.button("Random Sites").requireVisible();
    assertThat(frame.checkBox("Draw Vertex").target().isShowing()).isTrue();
  }

  @Test
  void aSampleIsOpenedSavedUnderANewNameAndOpenedAgain() throws Exception {
    String name = Samples.names().get(0);
    clickMenu("File");
    clickMenu("Open Sample");
    clickMenu(name);
    Points sample = points();
    assertThat(sample).isEqualTo(Samples.read(name).points());
    assertThat(window.getTitle()).startsWith(name);

    menu("Save");
    typeName(folder.resolve("mine").toString());
    Domain domain = window.workbench().domain().orElseThrow();
    String saved = domain == Domain.POLYGON ? "mine_polygonbased.txt" : "mine_pointbased.txt";
    await("the file is saved", () -> Files.exists(folder.resolve(saved)));
    settle();
    assertThat(window.getTitle()).startsWith(saved);

    push("Clear Canvas");
    type(KeyEvent.VK_O, KeyEvent.VK_CONTROL);
    typeName(folder.resolve("mine").toString());
    answer(dialog(), "Don't Save");
    assertThat(points()).isEqualTo(sample);
    assertThat(window.getTitle()).startsWith(saved);
  }

  @Test
  void saveAsWritesNoFileThatItsEndingDoesNotSay() {
    drawTriangle();
    menu("Save As");
    typeName(folder.resolve("mine.off").toString());
    JOptionPaneFixture sorry = dialog();
    assertThat(message(sorry)).contains("Export Data writes .off");
    answer(sorry, "OK");
    typeName(folder.resolve("mine.PNG").toString());
    sorry = dialog();
    assertThat(message(sorry)).contains("Export Picture writes .png");
    answer(sorry, "OK");
    typeName(folder.resolve("mine.json").toString());
    settle();
    assertThat(folder).isDirectoryContaining("glob:**mine.json");
    assertThat(folder).isDirectoryNotContaining("glob:**mine.{off,PNG}");
  }

  @Test
  void thePanelOfTheFirstExportBeginsWhereTheDocumentIs() throws Exception {
    Path sites = folder.resolve("a_pointbased.txt");
    PointFile.write(sites, Domain.SITES, TRIANGLE, Progress.NONE);
    onEventThread(
        () -> {
          window.open(sites);
          return null;
        });
    settle();
    menu("Export Picture");
    JFileChooserFixture panel =
        JFileChooserFinder.findFileChooser().withTimeout(PATIENCE_MILLIS).using(robot);
    assertThat(onEventThread(() -> panel.target().getCurrentDirectory().toPath().toRealPath()))
        .isEqualTo(folder.toRealPath());
    panel.cancel();
  }

  @Test
  void openSwitchesToTheApplicationOfTheFile() throws Exception {
    Path sites = folder.resolve("a_pointbased.txt");
    PointFile.write(sites, Domain.SITES, TRIANGLE, Progress.NONE);
    choose("Polygon Based");
    open(sites);
    frame.radioButton("Point Sites Based").requireSelected();
    assertThat(points()).isEqualTo(TRIANGLE);
  }

  @Test
  void aFileIsSavedWhileASearchRuns() throws Exception {
    drawTriangle();
    CountDownLatch end = new CountDownLatch(1);
    search(end);
    menu("Save");
    typeName(folder.resolve("mine").toString());
    Path file = folder.resolve("mine_polygonbased.txt");
    await("the file is saved", () -> onEventThread(() -> window.getTitle().startsWith("mine_")));
    assertThat(file).hasContent("100 100\n500 100\n300 400\n");
    assertThat(onEventThread(() -> window.workbench().jobs().isIdle())).isFalse();
    end.countDown();
    settle();
  }

  @Test
  void aFileIsOpenedAndAPictureExportedWhileASearchRuns() throws Exception {
    Path sites = folder.resolve("a_pointbased.txt");
    PointFile.write(sites, Domain.SITES, TRIANGLE, Progress.NONE);
    choose("Polygon Based");
    CountDownLatch end = new CountDownLatch(1);
    search(end);
    menu("Open");
    typeName(sites.toString());
    await("the file is open", () -> onEventThread(() -> window.getTitle().startsWith("a_point")));
    menu("Export Picture");
    typeName(folder.resolve("picture.svg").toString());
    await("the picture", () -> frame.label("status").text().startsWith("Exported "));
    assertThat(folder.resolve("picture.svg")).isNotEmptyFile();
    assertThat(onEventThread(() -> window.workbench().jobs().work())).containsExactly("Search");
    clickMenu("File");
    clickMenu("Exit");
    JOptionPaneFixture question = dialog();
    assertThat(message(question)).contains("What is going on would end: Search.");
    end.countDown();
    answer(question, "Cancel");
  }

  /** Runs a search until the latch is down. */
  private void search(CountDownLatch end) {
    onEventThread(
        () ->
            window.workbench().jobs().submitSearch("Search", progress -> isDown(end), found -> {}));
  }

  private static boolean isDown(CountDownLatch latch) {
    try {
      return latch.await(PATIENCE_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void exitWaitsForWhatIsBeingSaved() {
    choose("Polygon Based");
    CountDownLatch end = new CountDownLatch(1);
    onEventThread(
        () -> window.workbench().jobs().write("Slow", progress -> isDown(end), written -> {}));
    onEventThread(
        () -> {
          window.exit();
          return null;
        });
    assertThat(frame.label("status").text()).startsWith("Closing as soon as");
    requireNoDialog();
    end.countDown();
    answer(dialog(), "Cancel");
    assertThat(window.isShowing()).isTrue();
  }

  @Test
  void savingAsksBeforeReplacing() throws Exception {
    Path file = folder.resolve("old_polygonbased.txt");
    Files.writeString(file, "0 0\n9 0\n0 9\n");
    drawTriangle();
    menu("Save");
    typeName(folder.resolve("old").toString());
    JOptionPaneFixture question = dialog();
    assertThat(message(question)).contains("old_polygonbased.txt is there already");
    answer(question, "Cancel");
    assertThat(Files.readString(file)).isEqualTo("0 0\n9 0\n0 9\n");
    type(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
    typeName(folder.resolve("old").toString());
    answer(dialog(), "Replace");
    assertThat(Files.readString(file)).isEqualTo("100 100\n500 100\n300 400\n");
  }

  @Test
  void savingInAPlaceThatIsNotThereLosesNothing() {
    drawTriangle();
    menu("Save");
    typeName(folder.resolve("nowhere").resolve("mine").toString());
    JOptionPaneFixture dialog = dialog();
    assertThat(message(dialog)).contains("cannot be written").contains("nothing was changed");
    answer(dialog, "OK");
    assertThat(points()).isEqualTo(TRIANGLE);
    assertThat(window.getTitle()).startsWith("*");
  }

  @Test
  void aPolygonThatIsNotSimpleIsSavedAndOpenedAgain() {
    choose("Polygon Based");
    clickAt(100, 100, 500, 400, 500, 100, 100, 400);
    Points bowTie = points();
    menu("Save");
    typeName(folder.resolve("tie").toString());
    settle();
    requireNoDialog();
    push("Clear Canvas");
    open(folder.resolve("tie"));
    answer(dialog(), "Don't Save");
    assertThat(points()).isEqualTo(bowTie);
    requireNoDialog();
  }

  @ParameterizedTest(name = "{0}")
  @ValueSource(
      strings = {
        "1 2\n",
        "1 2\n3 4\n",
        "0 0\n9 0\n9 0\n0 9\n",
        "0 0\n5 5\n9 9\n",
        "0 0\n9 9\n9 0\n0 9\n",
        "0 0\n9 0\n5 0\n5 9\n"
      })
  void whatCannotBeTriangulatedOpensAllTheSame(String content) throws Exception {
    for (String suffix : new String[] {"_polygonbased", "_pointbased"}) {
      Path file = folder.resolve("odd" + suffix + ".txt");
      Files.writeString(file, content);
      open(file);
      settle();
      requireNoDialog();
      assertThat(window.getTitle()).startsWith(file.getFileName().toString());
      assertThat(points().size()).isPositive();
    }
  }

  @Test
  void savingGoesToTheFileThatTheDocumentCameFrom() throws Exception {
    Path one = Files.createDirectory(folder.resolve("one")).resolve("a_polygonbased.txt");
    Path two = Files.createDirectory(folder.resolve("two")).resolve("b_pointbased.txt");
    Files.writeString(one, "100 100\n500 100\n300 400\n");
    Files.writeString(two, "100 100\n500 100\n300 400\n");
    open(one);
    open(two);
    choose("Polygon Based");
    check("Draw Vertex");
    clickAt(150, 300);
    type(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
    requireNoDialog();
    assertThat(frame.label("status").text()).isEqualTo("Saved " + one);
    assertThat(one).hasContent("100 100\n500 100\n300 400\n150 300\n");
    assertThat(two).hasContent("100 100\n500 100\n300 400\n");
  }

  @Test
  void aFileThatAnotherProgramHasChangedIsNamedBeforeItIsOverwritten() throws Exception {
    Path file = folder.resolve("a_polygonbased.txt");
    Files.writeString(file, "100 100\n500 100\n300 400\n");
    open(file);
    check("Draw Vertex");
    clickAt(150, 300);
    Files.writeString(file, "1 1\n5 1\n3 4\n"); // of the same size
    type(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
    JOptionPaneFixture question = dialog();
    assertThat(message(question)).startsWith("a_polygonbased.txt has been changed");
    pressEnter(question);
    assertThat(file).hasContent("1 1\n5 1\n3 4\n");
    assertThat(window.getTitle()).startsWith("*");
    type(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
    answer(dialog(), "Overwrite");
    assertThat(file).hasContent("100 100\n500 100\n300 400\n150 300\n");
    clickAt(140, 290);
    type(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
    requireNoDialog();
    assertThat(window.getTitle()).startsWith("a_");
  }

  /** Presses Enter in a dialog, which has the focus. */
  private void pressEnter(JOptionPaneFixture dialog) {
    robot.waitForIdle();
    robot.pressAndReleaseKeys(KeyEvent.VK_ENTER);
    await("the dialog is closed", () -> !dialog.target().isShowing());
    settle();
  }

  @Test
  void enterLosesNothing() throws Exception {
    Path file = folder.resolve("old_polygonbased.txt");
    Files.writeString(file, "0 0\n9 0\n0 9\n");
    drawTriangle();
    menu("Save");
    typeName(folder.resolve("old").toString());
    pressEnter(dialog());
    assertThat(file).hasContent("0 0\n9 0\n0 9\n");
    menu("Exit");
    pressEnter(dialog());
    assertThat(window.isShowing()).isTrue();
    assertThat(points()).isEqualTo(TRIANGLE);
  }

  @Test
  void wishesAreKeptInJson() throws Exception {
    drawTriangle();
    type(KeyEvent.VK_W);
    clickAt(500, 100);
    menu("Save");
    typeName(folder.resolve("mine.json").toString());
    settle();
    assertThat(folder.resolve("mine.json"))
        .hasContent(
            "{\"kind\": \"polygon\", \"wishes\": \"eoe\", \"points\": [\n"
                + "[100, 100],\n[500, 100],\n[300, 400]]}");
    menu("New");
    requireNoDialog();
    open(folder.resolve("mine.json"));
    assertThat(onEventThread(() -> window.workbench().document().wishes()))
        .isEqualTo(ParityGoal.of(Wish.EVEN, Wish.ODD, Wish.EVEN));
  }

  @Test
  void openAsksBeforeChangesAreLost() throws Exception {
    Path other = folder.resolve("other_polygonbased.txt");
    PointFile.write(other, Domain.POLYGON, Points.ofPairs(10, 10, 90, 10, 50, 80), Progress.NONE);
    drawTriangle();
    open(other);
    JOptionPaneFixture dialog = dialog();
    assertThat(message(dialog)).contains("changes that are not saved");
    answer(dialog, "Cancel");
    assertThat(points()).isEqualTo(TRIANGLE);
  }

  static Stream<Arguments> badFiles() {
    return Stream.of(
        Arguments.of("empty", "", "is empty"),
        Arguments.of("no-points", "{\"points\": []}", "no points"),
        Arguments.of(
            "short-wishes",
            "{\"wishes\": \"eo\", \"points\": [[1, 2], [3, 4], [5, 7]]}",
            "3 letters"),
        Arguments.of("binary", "\u0000\u0001\u0002\u007f\n\u0000\u0000", "line 1"),
        Arguments.of("word", "0 0\n9 0\nseven 9\n", "line 3"),
        Arguments.of("one-number", "0 0\n9\n0 9\n", "line 2"),
        Arguments.of("nan", "0 0\n9 NaN\n0 9\n", "line 2"),
        Arguments.of("infinity", "0 0\n9 0\n0 Infinity\n", "line 3"),
        Arguments.of("huge", "0 0\n1e400 0\n0 9\n", "line 2"),
        Arguments.of("hexadecimal", "0x10 0\n9 0\n0 9\n", "line 1"),
        Arguments.of("latin-1", "0 0\n9 \u00e9\n0 9\n", "line 2"),
        Arguments.of("decimal-comma", "0,5 0,5\n9,5 0\n0 9\n", "line 1"),
        Arguments.of("garbage", "#!x\n".repeat(3) + "garbage\n".repeat(1_000_000), "line 4"));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("badFiles")
  void aBadFileGivesOneSentenceAndChangesNothing(String name, String content, String says)
      throws Exception {
    Path file = folder.resolve(name + "_polygonbased.txt");
    Files.write(file, content.getBytes(StandardCharsets.ISO_8859_1));
    drawTriangle();
    open(file);
    requireRefusal(file.getFileName().toString(), says);
  }

  @Test
  void aMissingFileGivesOneSentenceAndChangesNothing() {
    drawTriangle();
    open(folder.resolve("missing.txt"));
    requireRefusal("missing.txt", "no such file");
  }

  @Test
  void aFolderGivesOneSentenceAndChangesNothing() {
    drawTriangle();
    // The file panel enters folders; one can be named only when the program is started.
    onEventThread(
        () -> {
          window.open(folder);
          return null;
        });
    requireRefusal(folder.getFileName().toString(), "folder");
  }

  private void requireRefusal(String file, String says) {
    JOptionPaneFixture dialog = dialog();
    assertThat(message(dialog)).startsWith(file).contains(says).doesNotContain("\n");
    answer(dialog, "OK");
    requireNoDialog();
    assertThat(points()).isEqualTo(TRIANGLE);
    frame.radioButton("Polygon Based").requireSelected();
    assertThat(window.getTitle()).startsWith("*New polygon");
  }

  @Test
  void exitAsksAndThenCloses() {
    drawTriangle();
    ResultFrame result = pushForResult("Monotone Polygon Triangulation");
    toFront();
    menu("Exit");
    JOptionPaneFixture question = dialog();
    assertThat(message(question)).contains("not saved").contains("New polygon");
    answer(question, "Cancel");
    assertThat(window.isShowing()).isTrue();
    toFront();
    menu("Exit");
    robot.click(dialog().buttonWithText("Don't Save").target());
    await("the window is closed", () -> !window.isShowing() && !result.isShowing());
  }

  private void toFront() {
    onEventThread(
        () -> {
          window.toFront();
          return null;
        });
    robot.waitForIdle();
  }

  private JFileChooserFixture exportPanel() {
    menu("Export Picture");
    return JFileChooserFinder.findFileChooser().withTimeout(PATIENCE_MILLIS).using(robot);
  }

  @Test
  void aPictureIsExportedInTheSizeAskedFor() throws Exception {
    drawTriangle();
    JFileChooserFixture panel = exportPanel();
    assertThat(onEventThread(() -> panel.target().getDialogTitle())).isEqualTo("Export Picture");
    pick(panel, "extent", 1);
    pick(panel, "scale", 1);
    typeName(folder.resolve("picture").toString());
    Path file = folder.resolve("picture.png");
    settle();
    assertThat(ImageIO.read(file.toFile()).getWidth()).isEqualTo(2 * canvas().getWidth());
    assertThat(frame.label("status").text()).isEqualTo("Exported " + file);
  }

  private void pick(JFileChooserFixture panel, String name, int index) {
    onEventThread(
        () -> {
          field(panel, name, javax.swing.JComboBox.class).setSelectedIndex(index);
          return null;
        });
  }

  private <T extends java.awt.Component> T field(
      JFileChooserFixture panel, String name, Class<T> kind) {
    return robot.finder().findByName(panel.target(), name, kind);
  }

  private void width(JFileChooserFixture panel, String text) {
    onEventThread(
        () -> {
          field(panel, "width", javax.swing.JComboBox.class).setSelectedItem(text);
          return null;
        });
  }

  @Test
  void aFigureForAPaperIsExportedAndTheChoiceIsKept() throws Exception {
    drawTriangle();
    JFileChooserFixture panel = exportPanel();
    pick(panel, "theme", 1);
    for (String box : List.of("coordinates", "legend", "upwards", "standalone")) {
      javax.swing.JCheckBox tick = field(panel, box, javax.swing.JCheckBox.class);
      onEventThread(
          () -> {
            tick.doClick();
            return null;
          });
    }
    typeName(folder.resolve("figure.svg").toString());
    settle();
    assertThat(Files.readString(folder.resolve("figure.svg")))
        .contains("width=\"84mm\"")
        .contains("boundary")
        .contains("(300, 400)");
    JFileChooserFixture again = exportPanel();
    assertThat(onEventThread(() -> again.target().getSelectedFile().getName())).endsWith(".svg");
    javax.swing.JCheckBox legend = field(again, "legend", javax.swing.JCheckBox.class);
    javax.swing.JCheckBox upwards = field(again, "upwards", javax.swing.JCheckBox.class);
    assertThat(onEventThread(legend::isSelected)).isTrue();
    assertThat(onEventThread(upwards::isSelected)).isFalse(); // as on the canvas
    width(again, "100mm");
    typeName(folder.resolve("wide.tex").toString());
    settle();
    assertThat(Files.readString(folder.resolve("wide.tex"))).contains("\\documentclass");
    assertThat(session.settings().get("figure.width")).contains("100mm");
  }

  @Test
  void aWidthThatIsNoneIsSaidAndAskedForAgain() {
    drawTriangle();
    width(exportPanel(), "7 furlongs");
    typeName(folder.resolve("figure.svg").toString());
    JOptionPaneFixture refusal = dialog();
    assertThat(message(refusal)).isEqualTo("7 furlongs is no width; write 84mm or 600px.");
    answer(refusal, "OK");
    JFileChooserFixture again =
        JFileChooserFinder.findFileChooser().withTimeout(PATIENCE_MILLIS).using(robot);
    width(again, "600px");
    typeName(folder.resolve("figure.svg").toString());
    settle();
    assertThat(folder.resolve("figure.svg")).exists();
  }

  @Test
  void wishesAreLoadedAndSaved() throws Exception {
    Path wishes = folder.resolve("mine.txt");
    Files.writeString(wishes, "0 odd\n1 even # as it is\n2 any\n");
    drawTriangle();
    wishedParities("Load Wishes");
    typeName(wishes.toString());
    answer(dialog(), "Cancel");
    assertThat(onEventThread(() -> window.workbench().document().wishes()))
        .isEqualTo(ParityGoal.of(Wish.ODD, Wish.EVEN, Wish.ANY));
    wishedParities("Save Wishes");
    Path saved = folder.resolve("saved.txt");
    typeName(saved.toString());
    await("the wishes are saved", () -> Files.exists(saved));
    assertThat(Files.readString(saved)).isEqualTo("0 odd\n2 any\n");
  }

  @Test
  void badWishesGiveOneSentenceAndChangeNothing() throws Exception {
    Path wishes = folder.resolve("bad.txt");
    Files.writeString(wishes, "0 odd\n7 any\n");
    drawTriangle();
    wishedParities("Load Wishes");
    typeName(wishes.toString());
    JOptionPaneFixture dialog = dialog();
    assertThat(message(dialog)).startsWith("bad.txt, line 2: there is no vertex 7");
    answer(dialog, "OK");
    assertThat(onEventThread(() -> window.workbench().document().wishes()))
        .isEqualTo(ParityGoal.allEven(3));
  }

  @Test
  void wishesAreNotLostWithoutAQuestion() throws Exception {
    Path file = folder.resolve("a_polygonbased.txt");
    PointFile.write(file, Domain.POLYGON, TRIANGLE, Progress.NONE);
    open(file);
    type(KeyEvent.VK_W);
    clickAt(100, 100);
    menu("New");
    JOptionPaneFixture dialog = dialog();
    assertThat(message(dialog)).contains("wished parities that are not saved");
    answer(dialog, "Cancel");
    assertThat(points()).isEqualTo(TRIANGLE);
    menu("New");
    answer(dialog(), "Don't Save");
    assertThat(points().size()).isZero();
  }

  private void wishedParities(String button) {
    clickMenu("Triangulate");
    clickMenu("Wished Parities…");
    answer(dialog(), button);
  }

  @Test
  void f1ListsTheCommands() {
    type(KeyEvent.VK_F1);
    robot.waitForIdle();
    assertThat(robot.finder().findByName("commands", javax.swing.JTable.class, true).getRowCount())
        .isGreaterThan(20);
  }

  private void drawTriangle() {
    choose("Polygon Based");
    clickAt(100, 100, 500, 100, 300, 400);
  }

  private void menu(String item) {
    clickMenu("File");
    clickMenu(item);
  }

  private void open(Path file) {
    menu("Open");
    typeName(file.toString());
    robot.waitForIdle();
  }
}
