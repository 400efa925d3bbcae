package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.experiment.generate.PolygonShape;
import dct.ui.solve.ResultFrame;
import dct.ui.study.StudyDialog;
import java.awt.Frame;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.data.TableCell;
import org.assertj.swing.finder.JFileChooserFinder;
import org.assertj.swing.finder.WindowFinder;
import org.assertj.swing.fixture.DialogFixture;
import org.assertj.swing.fixture.JFileChooserFixture;
import org.assertj.swing.fixture.JTableFixture;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The dialog of a study, driven from the menu to the pictures of a row. */
@Tag("gui")
class StudyWindowTest extends WindowTest {
  @TempDir Path folder;
  private DialogFixture dialog;

  private void open(String study) {
    clickMenu("Study");
    clickMenu(study + "…");
    dialog = WindowFinder.findDialog("study").withTimeout(PATIENCE_MILLIS).using(robot);
    await("the dialog is shown", () -> dialog.target().isShowing());
    robot.waitForIdle();
  }

  private void run(String sizes, String sets) {
    fill(dialog.textBox("Sizes"), sizes);
    fill(dialog.textBox("Sets"), sets);
    start();
    awaitEnd();
  }

  private void start() {
    click(() -> dialog.button("Start").click());
  }

  private void awaitEnd() {
    StudyDialog target = (StudyDialog) dialog.target();
    await("the study has ended", () -> onEventThread(target::isIdle));
    robot.waitForIdle();
  }

  private JTableFixture table() {
    return dialog.table("rows");
  }

  private int number(int row, String column) {
    return Integer.parseInt(table().cell(TableCell.row(row).column(column(column))).value());
  }

  private int column(String name) {
    return onEventThread(() -> table().target().getColumnModel().getColumnIndex(name));
  }

  @Test
  void a_small_study_of_polygons_to_the_pictures_of_a_row() {
    open("Polygons");
    click(() -> dialog.list("Shapes").selectItem(PolygonShape.STAR_SHAPED.word()));
    run("14,30", "3");
    table().requireRowCount(6);
    assertThat(IntStream.range(0, 6).map(r -> number(r, "n")).toArray())
        .containsExactly(14, 30, 14, 30, 14, 30);
    requireChart();

    int even = number(1, "even partitioning aqt flip");
    int best = number(1, "even best");
    long seed = Long.parseLong(table().cell(TableCell.row(1).column(column("seed"))).value());
    robot.click(
        table().target(),
        onEventThread(
            () -> {
              var cell = table().target().getCellRect(1, 0, true);
              return new java.awt.Point((int) cell.getCenterX(), (int) cell.getCenterY());
            }),
        MouseButton.LEFT_BUTTON,
        2);
    await("three pictures", () -> results().size() == 3);
    Points expected = PolygonShape.STAR_SHAPED.generate(30, seed).points();
    List<Frame> pictures = results();
    for (Frame picture : pictures) {
      assertThat(picture.getTitle()).contains("star-shaped 30, seed " + seed);
      assertThat(((ResultFrame) picture).canvas().scene().points()).isEqualTo(expected);
    }
    assertThat(counts(pictures, "Partitioning-AQT and Scan-Flip")).contains("After: Even " + even);
    assertThat(counts(pictures, "Best")).contains("Even " + best, "optimal");
  }

  private static String counts(List<Frame> pictures, String method) {
    return pictures.stream()
        .filter(picture -> picture.getTitle().startsWith(method + " ·"))
        .map(picture -> String.join(" ", ((ResultFrame) picture).canvas().scene().counts()))
        .findFirst()
        .orElseThrow();
  }

  private void requireChart() {
    BufferedImage image = capture(robot.finder().findByName(dialog.target(), "chart"));
    long colours =
        IntStream.range(0, image.getWidth() * image.getHeight())
            .map(i -> image.getRGB(i % image.getWidth(), i / image.getWidth()))
            .distinct()
            .count();
    assertThat(colours).as("colours of the chart").isGreaterThan(8);
  }

  @Test
  void a_study_of_sites_is_cancelled_and_goes_on_where_it_was() {
    open("Point Sites");
    fill(dialog.textBox("Sizes"), "2000,3000");
    fill(dialog.textBox("Sets"), "400");
    start();
    await("some rows", () -> onEventThread(() -> table().target().getRowCount()) > 4);
    click(() -> dialog.button("Cancel").click());
    awaitEnd();
    int kept = table().target().getRowCount();
    assertThat(kept).isBetween(5, 799);
    String first = table().cell(TableCell.row(0).column(3)).value();

    fill(dialog.textBox("Sets"), "1");
    start();
    awaitEnd();
    table().requireRowCount(2);
    assertThat(table().cell(TableCell.row(0).column(3)).value()).isEqualTo(first);
    assertThat(dialog.button("Cancel").isEnabled()).isFalse();
  }

  @Test
  void rows_are_sorted_by_a_click_on_a_head_and_exported() throws Exception {
    open("Point Sites");
    run("30-50:10", "2");
    table().requireRowCount(6);
    click(() -> table().tableHeader().clickColumn("n"));
    assertThat(IntStream.range(0, 6).map(r -> number(r, "n")).toArray()).isSorted();

    for (String ending : List.of("csv", "tex", "svg")) {
      Path file = folder.resolve("study." + ending);
      clickForDialog(() -> dialog.button("Export").click());
      JFileChooserFixture chooser =
          JFileChooserFinder.findFileChooser().withTimeout(PATIENCE_MILLIS).using(robot);
      fill(chooser.fileNameTextBox(), file.toString());
      robot.pressAndReleaseKeys(KeyEvent.VK_ENTER);
      await("the file panel is closed", () -> !chooser.target().isShowing());
      await("the file", () -> Files.exists(file));
      robot.waitForIdle();
    }
    assertThat(Files.readAllLines(folder.resolve("study.csv"))).hasSize(7);
    assertThat(folder.resolve("study.tex")).content().contains("\\toprule");
  }

  @Test
  void what_cannot_be_studied_is_said() {
    open("Point Sites");
    fill(dialog.textBox("Sizes"), "2");
    clickForDialog(() -> dialog.button("Start").click());
    assertThat(message(dialog())).contains("The sizes cannot be used: 2 is not from 3 to");
    answer(dialog(), "OK");
    table().requireRowCount(0);
  }
}
