package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.triangulate.Triangulation;
import dct.problem.Solution;
import dct.ui.command.CommandRegistry;
import dct.ui.solve.ResultFrame;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The keys of the File menu, pressed in the frame of a result. */
class ResultFilesWindowTest extends WindowTest {
  private static final double[] DRAWN = {
    100, 100, 300, 60, 500, 120, 560, 300, 800, 200, 900, 400, 850, 600, 600, 650, 450, 500, 200,
    620, 80, 400
  };

  @TempDir Path folder;

  @Test
  void saveKeepsTheDrawingWithTheResultThatTheFrameShows() throws Exception {
    Path points = folder.resolve("a_polygonbased.txt");
    draw();
    ResultFrame frame = pushForResult("Monotone Polygon Triangulation");
    typeIn(frame, KeyEvent.VK_S, KeyEvent.VK_CONTROL);
    saveAs(folder.resolve("mine").toString()); // nothing says in what kind of file
    Path file = folder.resolve("mine_polygonbased.json");
    assertThat(status(frame)).isEqualTo("Saved " + file);
    assertThat(window.getTitle()).startsWith("mine_polygonbased.json");
    assertThat(onEventThread(frame::getTitle)).endsWith(" · mine_polygonbased.json");
    assertThat(file).content().contains("\"edges\"");

    typeIn(frame, KeyEvent.VK_S, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    saveAs(points.toString());
    assertThat(points).exists();
    typeIn(frame, KeyEvent.VK_S, KeyEvent.VK_CONTROL); // that file keeps no triangulation
    saveAs(folder.resolve("again").toString());
    assertThat(folder.resolve("again_polygonbased.json")).hasSameTextualContentAs(file);
  }

  @Test
  void saveWritesAtOnceWhereTheFileKeepsAll() throws Exception {
    Path file = folder.resolve("mine.json");
    draw();
    ResultFrame frame = pushForResult("Monotone Polygon Triangulation");
    typeIn(frame, KeyEvent.VK_S, KeyEvent.VK_CONTROL);
    saveAs(file.toString());
    perform("Perform Flip");
    await("the flips", () -> results().size() == 2);
    ResultFrame flipped =
        (ResultFrame) results().stream().filter(f -> f != frame).findFirst().orElseThrow();
    typeIn(flipped, KeyEvent.VK_S, KeyEvent.VK_CONTROL);
    requireNoDialog();
    assertThat(status(flipped)).isEqualTo("Saved " + file);
    assertThat(file).content().contains("flips");
  }

  @Test
  void theTitleSaysThatTheFileStillHoldsFlipsThatAreUndone() throws Exception {
    draw();
    ResultFrame monotone = pushForResult("Monotone Polygon Triangulation");
    perform("Perform Flip");
    perform("Save As");
    saveAs(folder.resolve("mine.json").toString());
    assertThat(title()).startsWith("mine.json");
    perform(monotone.commands(), "Undo");
    assertThat(title()).startsWith("*mine.json");
    perform(monotone.commands(), "Redo");
    assertThat(title()).startsWith("mine.json");
  }

  @Test
  void aResultOfEarlierIsSavedAsACopy() throws Exception {
    Path own = folder.resolve("mine.json");
    draw();
    ResultFrame monotone = pushForResult("Monotone Polygon Triangulation");
    Optional<Solution> first = solution();
    perform("Perform Flip");
    perform("Save As");
    saveAs(own.toString());
    String before = Files.readString(own);
    perform(monotone.commands(), "Save");
    saveAs(folder.resolve("copy").toString());
    assertThat(own).hasContent(before);
    assertThat(window.getTitle()).startsWith("mine.json");
    onEventThread(
        () -> {
          window.open(folder.resolve("copy_polygonbased.json"));
          return null;
        });
    await("the copy is open", () -> onEventThread(() -> window.getTitle().startsWith("copy_")));
    assertThat(edges(solution())).isEqualTo(edges(first));
  }

  @Test
  void closeClosesTheFrameAndNothingElse() {
    draw();
    ResultFrame frame = pushForResult("Monotone Polygon Triangulation");
    typeIn(frame, KeyEvent.VK_W, KeyEvent.VK_CONTROL);
    await("the frame is closed", () -> results().isEmpty());
    assertThat(window.isShowing()).isTrue();
    assertThat(solution()).isPresent();
  }

  private void draw() {
    choose("Polygon Based");
    check("Draw Vertex");
    clickAt(DRAWN);
  }

  private static Set<Set<Integer>> edges(Optional<Solution> of) {
    Triangulation triangulation = of.orElseThrow().triangulation();
    return IntStream.range(0, triangulation.edgeCount())
        .mapToObj(edge -> Set.of(triangulation.from(edge), triangulation.to(edge)))
        .collect(Collectors.toSet());
  }

  private Optional<Solution> solution() {
    return onEventThread(() -> window.workbench().solution());
  }

  private String title() {
    return onEventThread(window::getTitle);
  }

  private void perform(String command) {
    perform(window.commands(), command);
  }

  /** Does what may open a dialog. */
  private void perform(CommandRegistry commands, String command) {
    SwingUtilities.invokeLater(() -> commands.get(command).perform());
    robot.waitForIdle();
    settle();
  }

  private void typeIn(ResultFrame frame, int key, int... modifiers) {
    robot.focusAndWaitForFocusGain(frame.canvas());
    for (int modifier : modifiers) {
      robot.pressKey(modifier);
    }
    robot.pressAndReleaseKeys(key);
    for (int modifier : modifiers) {
      robot.releaseKey(modifier);
    }
    settle();
  }

  private void saveAs(String name) {
    typeName(name);
    settle();
  }
}
