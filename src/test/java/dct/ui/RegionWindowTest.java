package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.problem.Solution;
import dct.render.Ink;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import dct.ui.document.Result;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Holes, inner sites and fixed edges by mouse and keyboard. */
class RegionWindowTest extends WindowTest {
  @TempDir private Path folder;

  private void drawSquareWithHole() {
    choose("Polygon Based");
    clickAt(100, 100, 600, 100, 600, 500, 100, 500);
    type(KeyEvent.VK_ENTER);
    type(KeyEvent.VK_H);
    frame.checkBox("Draw Vertex").requireSelected();
    clickAt(250, 200, 450, 200, 450, 400, 250, 400, 251, 201);
    frame.checkBox("Edit Vertex").requireSelected();
  }

  private void steps(int count, Consumer<Editor> step) {
    onEventThread(
        () -> {
          for (int k = 0; k < count; k++) {
            step.accept(window.workbench().editor(Domain.POLYGON));
          }
          return null;
        });
  }

  private Document document() {
    return onEventThread(() -> window.workbench().document());
  }

  private Solution solution() {
    return document().result().map(Result::solution).orElseThrow();
  }

  @Test
  void aHoleIsDrawnTriangulatedAndUndone() {
    drawSquareWithHole();
    assertThat(document().content()).isEqualTo(Domain.REGION);
    assertThat(document().rings().ring(1)).containsExactly(4, 5, 6, 7);
    requireInk(canvas(), Ink.BOUNDARY, 250, 300);
    requireInk(canvas(), Ink.INSIDE, 175, 150);
    requireInk(canvas(), Ink.BACKGROUND, 350, 300);
    type(KeyEvent.VK_M, KeyEvent.VK_SHIFT);
    await("the triangulation", () -> document().result().isPresent());
    assertThat(solution().triangulation().triangleCount()).isEqualTo(8);
    menu("Triangulate", "Most Even Vertices");
    settle();
    await("the optimum", () -> solution().optimum().isPresent());
    assertThat(solution().optimum().orElseThrow().isProven()).isTrue();
    steps(6, Editor::undo); // the results and the vertices of the hole
    assertThat(document().content()).isEqualTo(Domain.POLYGON);
    steps(1, Editor::undo); // New Hole
    assertThat(document().layout().isPlain()).isTrue();
    steps(7, Editor::redo);
    assertThat(solution().optimum()).isPresent();
  }

  @Test
  void sitesAndFixedEdgesAreClicked() {
    drawSquareWithHole();
    type(KeyEvent.VK_I);
    clickAt(175, 300);
    assertThat(document().layout().sites(9)).isEqualTo(1);
    type(KeyEvent.VK_T);
    clickAt(100, 100, 250, 400);
    assertThat(document().rings().isFixed(0, 7)).isTrue();
    requireInk(canvas(), Ink.FIXED, 150, 200);
    press(600, 100); // a drag fixes, too
    moveTo(450, 200);
    release();
    assertThat(document().rings().isFixed(1, 5)).isTrue();
    clickAt(150, 200);
    assertThat(document().rings().fixedCount()).isEqualTo(1);
    type(KeyEvent.VK_S);
    clickAt(525, 151);
    assertThat(document().rings().fixedCount()).isEqualTo(2);
    assertThat(document().size()).isEqualTo(10);
    type(KeyEvent.VK_C, KeyEvent.VK_SHIFT);
    await("the triangulation", () -> document().result().isPresent());
    assertThat(solution().triangulation().edgeBetween(1, 9)).isPresent();
  }

  @Test
  void aDiagonalThatIsShownIsFixedByAClick() {
    drawSquareWithHole();
    type(KeyEvent.VK_L);
    await("the live triangulation", () -> live().isPresent());
    Triangulation shown = live().orElseThrow().triangulation();
    int edge =
        IntStream.range(0, shown.dcel().edgeBound())
            .filter(e -> !shown.dcel().isBoundary(e))
            .findFirst()
            .orElseThrow();
    int u = shown.from(edge);
    int v = shown.to(edge);
    type(KeyEvent.VK_T);
    Points points = shown.points();
    clickAt((points.x(u) + points.x(v)) / 2, (points.y(u) + points.y(v)) / 2);
    assertThat(document().rings().isFixed(u, v)).isTrue();
    type(KeyEvent.VK_S);
    clickAt(101, 290);
    assertThat(document().rings().ring(0)).hasSize(5);
  }

  private Optional<Solution> live() {
    return onEventThread(() -> window.workbench().shown().solution());
  }

  @Test
  void aVertexOfAHoleIsMovedAndDeleted() {
    drawSquareWithHole();
    press(450, 400);
    moveTo(650, 450);
    release();
    assertThat(frame.label("status").target().getText())
        .startsWith("Not simple: vertex v6 of a hole ");
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    type(KeyEvent.VK_X);
    clickAt(450, 400);
    assertThat(document().rings().ring(1)).containsExactly(4, 5, 6);
    clickAt(450, 200, 250, 200, 250, 400);
    assertThat(document().layout().isPlain()).isTrue();
  }

  @Test
  void ringsThatTouchAreSplitAndPartedAndThatIsUndone() {
    choose("Polygon Based");
    clickAt(100, 100, 600, 100, 600, 500, 100, 500);
    type(KeyEvent.VK_ENTER);
    type(KeyEvent.VK_H);
    clickAt(200, 200, 350, 120, 500, 200, 350, 400);
    type(KeyEvent.VK_ENTER);
    press(350, 120);
    moveTo(350, 100);
    release();
    Document touching = document();
    assertThat(frame.label("status").target().getText())
        .isEqualTo(
            "Not simple: vertex v5 touches edge v0–v1; Edit ▸ Go to Crossing, Split Ring…, "
                + "Part by a Hair");
    menu("Edit", "Part by a Hair");
    await("the parting", () -> !document().equals(touching));
    assertThat(onEventThread(() -> window.workbench().shown().defects())).isEmpty();
    assertThat(document().layout()).isEqualTo(touching.layout());
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(document()).isEqualTo(touching);
  }

  @Test
  void aRegionIsSavedAndOpenedAgain() throws Exception {
    drawSquareWithHole();
    type(KeyEvent.VK_I);
    clickAt(175, 300);
    Path text = folder.resolve("plate.txt");
    saveAs(text);
    assertThat(Files.readString(text)).contains("hole", "sites");
    Document drawn = document();
    openAgain(text, drawn);
    type(KeyEvent.VK_M, KeyEvent.VK_SHIFT);
    await("the triangulation", () -> document().result().isPresent());
    Path json = folder.resolve("plate.json");
    saveAs(json);
    Document made = document();
    openAgain(json, drawn);
    assertThat(document().result().orElseThrow().solution().triangulation().edgeCount())
        .isEqualTo(made.result().orElseThrow().solution().triangulation().edgeCount());
  }

  private void menu(String menu, String item) {
    clickMenu(menu);
    clickMenu(item);
  }

  private void saveAs(Path file) {
    menu("File", "Save As");
    typeName(file.toString());
    await("the file is saved", () -> Files.exists(file));
    settle();
  }

  private void openAgain(Path file, Document drawn) {
    onEventThread(
        () -> {
          window.workbench().editor(Domain.POLYGON).startAnew();
          return null;
        });
    SwingUtilities.invokeLater(() -> window.open(file));
    await("the file", () -> document().size() == drawn.size());
    assertThat(document().points()).isEqualTo(drawn.points());
    assertThat(document().rings().hasEdgesOf(drawn.rings())).isTrue();
  }

  @Test
  void ringsOfAnotherProgramAreOpenedWithTheirHoles() throws Exception {
    Path file = folder.resolve("holes.wkt");
    Files.writeString(
        file, "POLYGON ((0 0, 400 0, 400 300, 0 300, 0 0), (100 100, 200 100, 150 200, 100 100))");
    SwingUtilities.invokeLater(() -> window.open(file));
    answer(dialog(), "Open with Holes");
    await("the region", () -> document().size() == 7);
    assertThat(document().layout().holes()).isEqualTo(1);
  }
}
